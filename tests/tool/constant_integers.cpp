// constant(...), scratch(...) and extents say of integers, too, that they may be baked in.
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not=SYM0 --implicit-check-not="baked in"
// RUN: %symreal verify %s %t.c --samples=100
// CHECK: kernel evaluate
#include <cstdio>
#include <vector>

namespace {
int mode = 1;
bool switched = true;
} // namespace
int calls = 0;
static int rows = 2;

struct Model {
  int degree;
  std::vector<int> powers;
  int neighbour;
};

#pragma symreal function input(x[0:rows]) constant(mode, model.degree, model.powers, switched, terms) scratch(calls, neighbour) output(y[0:count])
void evaluate(Model &model, double *x, double *y, int count, int terms, int &neighbour) {
  calls = 3;
  neighbour = 4;
  for (int k = 0; k < count; k++) y[k] = mode * x[k % rows];
  for (int i = 0; i < terms; i++) y[0] += model.degree;
  for (int power : model.powers) y[0] *= power;
  if (switched) y[1] += x[0];
}

int main(int count, char **) {
  Model model{3, {2, 3}, 0};
  double x[2] = {0.5, 0.25}, y[3];
  evaluate(model, x, y, 3, 2, model.neighbour);
  std::printf("%g %d\n", y[0], calls);
  if (count > 100) mode = 2, switched = false, rows = 3;
}
