// Guards that no sample failed are listed in runs.
// RUN: %symreal generate %s --decisions=guard -o %t.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
#include <cstdio>

#pragma symreal function input(x[0:6]) range(1, 2) output(return)
double bounded(double const *x) {
  double sum = 0;
  for (int i = 0; i < 6; i++) {
    if (x[i] > (i == 3 ? 1.5 : 9.0)) return sum;
    sum += x[i] * x[i];
  }
  return sum;
}

// CHECK: no sample failed guard 1-3, 5, 6, so its other side was not tested
int main() {
  double const x[6] = {1, 1, 1, 1, 1, 1};
  std::printf("%g\n", bounded(x));
}
