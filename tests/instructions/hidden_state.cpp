// What the kernel reads and leaves besides its annotations is found in the instructions as well.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: not %symreal generate %s -o code.c --record=instructions > told 2>&1
// RUN: FileCheck %s < told
// RUN: not %symreal generate %s -o code.c --record=instructions -- -DKEEPS > kept 2>&1
// RUN: FileCheck %s --check-prefix=KEPT < kept
// RUN: not ls code.c
#include <vector>

double gain = 2;
static double total;
static int calls;
struct Model {
  double mass;
  int links;
  std::vector<double> lengths;
};

__attribute__((noinline)) static double length_of(Model const &model, int k) { return model.lengths[k]; }

#pragma symreal function input(x) output(return)
double step(Model const &model, double x) {
  // CHECK-DAG: hidden_state.cpp:[[@LINE+1]]:{{.*}}error: {{.*}}'gain'{{.*}} [SYM017]
  double sum = gain * x;
  for (int k = 0; k < model.links; ++k) sum += length_of(model, k) * model.mass;
#ifdef KEEPS
  // KEPT-DAG: hidden_state.cpp:[[@LINE+1]]:{{.*}}error: the kernel writes 'total', which is not an output [SYM053]
  total += sum;
  // KEPT-DAG: hidden_state.cpp:[[@LINE+1]]:{{.*}}error: the kernel writes 'calls', which is not an output [SYM053]
  ++calls;
#endif
  return sum;
}

int main() {
  Model const model{3, 2, {0.5, 0.25}};
  return step(model, 1) == 0;
}
