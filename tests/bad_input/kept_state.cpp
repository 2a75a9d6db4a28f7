// State that the kernel leaves behind in members, through pointers and in containers, and that is no output.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cstdio>
#include <vector>

struct Sample {
  double value, weight;
};

class Filter {
public:
  explicit Filter(double *last) : last_(last) {}
  double step(double x) {
    sum_ += x;
    history_.push_back(x);
    *last_ = 2.0 * x;
    newest_ = {x, 1.0};
    delete scratch_;
    scratch_ = new double(x);
    *scratch_ += 1.0; // it does not outlive the kernel
    delete scratch_;
    scratch_ = nullptr;
    return sum_;
  }

private:
  double sum_ = 0, *last_, *scratch_ = nullptr;
  Sample newest_ = {0, 0};
  std::vector<double> history_;
};

#pragma symreal function input(x) output(return, *shown)
double run(Filter &filter, double x, double *shown) {
  *shown = x + 1.0;
  return filter.step(x);
}

int main() {
  double last = 0, shown = 0;
  Filter filter(&last);
  std::printf("%g\n", run(filter, 0.5, &shown));
}

// CHECK-DAG: kept_state.cpp:16:5: error: the kernel writes 'sum_', which is not an output [SYM053]
// CHECK-DAG: kept_state.cpp:17:5: error: the kernel writes 'history_', which is not an output [SYM053]
// CHECK-DAG: kept_state.cpp:18:5: error: the kernel writes '*last_', which is not an output [SYM053]
// CHECK-DAG: kept_state.cpp:19:5: error: the kernel writes 'newest_', which is not an output [SYM053]
// CHECK-NOT: 'shown'
// CHECK-NOT: scratch_
