// What constant() and scratch() answer for, with what they own, is no hidden state.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o code.c --record=instructions > told 2>&1
// RUN: FileCheck %s < told
// CHECK-NOT: error
// CHECK: kernel step: 1 inputs, 0 parameters, 1 outputs
// RUN: %symreal verify %s code.c --samples=100 > verified 2>&1 && FileCheck %s --check-prefix=SAME < verified
// SAME: kernel step, mode finite: 100 samples{{.*}} 100 within the premises
#include <vector>

static double gain = 2, last;
struct Model {
  double mass;
  int links;
  std::vector<double> lengths;
};

#pragma symreal function input(x) range(-1, 1) constant(model, gain) scratch(last) output(return)
double step(Model const &model, double x) {
  double sum = gain * x;
  for (int k = 0; k < model.links; ++k) sum += model.lengths[k] * model.mass * x;
  last = sum;
  return sum;
}

int main() {
  Model const model{3, 2, {0.5, 0.25}};
  return step(model, 1) == 0;
}
