// scratch(object) is also about what the object owns, however it does: private members, a class that is hidden behind a
// pointer, containers of pointers.
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not=SYM0
// RUN: %symreal verify %s %t.c --samples=100
// CHECK: kernel solve
#include <cstdio>
#include <memory>
#include <vector>

struct Row {
  double value = 0;
  int uses = 0;
};

class Solver {
public:
  Solver();
  double solve(double x);

private:
  struct Hidden;
  Hidden *hidden_;
  std::unique_ptr<Row> last_ = std::make_unique<Row>();
  std::vector<Row *> rows_;
  std::vector<std::unique_ptr<Row[]>> tables_;
  double sum_ = 0;
};

struct Solver::Hidden {
  double work[2] = {0, 0};
  std::vector<double> grown;
};

Solver::Solver() : hidden_(new Hidden), rows_{new Row, new Row} { tables_.push_back(std::make_unique<Row[]>(3)); }

double Solver::solve(double x) {
  hidden_->work[1] = x;
  hidden_->grown.assign(3, x);
  last_->value = x * x;
  for (Row *row : rows_) row->value = last_->value, row->uses = 1;
  tables_[0][2].value = rows_[1]->value - x;
  sum_ = tables_[0][2].value + hidden_->work[1] * hidden_->grown[2];
  return sum_;
}

#pragma symreal function input(x) scratch(solver) output(return)
double solve(Solver &solver, double x) { return solver.solve(x); }

int main() {
  Solver solver;
  std::printf("%g\n", solve(solver, 0.5));
}
