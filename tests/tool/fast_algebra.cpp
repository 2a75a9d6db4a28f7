// Mode fast, from a program to verified code: powers, a sum of angles, divisions by a parameter and sums with parameters.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/k.c --fp=fast
// RUN: FileCheck %s < %t/k.c
// RUN: %symreal verify %s %t/k.c 2>&1 | FileCheck %s --check-prefix=VERIFIED
// RUN: %symreal generate %s -o %t/balanced.c --fp=fast --passes=default,balance && %symreal verify %s %t/balanced.c
// RUN: %symreal generate %s -o %t/without.c --fp=fast --effort=0 && %symreal verify %s %t/without.c
// RUN: FileCheck %s --check-prefix=WITHOUT < %t/without.c
#include <cmath>
#include <cstdio>

#pragma symreal function input(q[0:2], r) parameter(m, offset) output(y[0:5])
void model(double const *q, double r, double m, double offset, double *y) {
  y[0] = std::cos(q[0]) + std::cos(q[0] + q[1]) + std::cos(q[1]);
  y[1] = std::sin(q[0]) + std::sin(q[0] + q[1]) + std::sin(q[1]);
  y[2] = 4 * (std::pow(r, -12) - std::pow(r, -6));
  y[3] = (r + m) * std::pow(r, 1.5) / m + q[0] / m + q[1] / m;
  y[4] = (r + offset) + m;
}

int main() {
  double const q[2] = {0.3, 0.5};
  double y[5];
  model(q, 1.5, 2, 0.25, y);
  std::printf("%g\n", y[0]);
}

// CHECK: void compute(
// CHECK-NOT: {{pow|/ constants|sin\(.*\+|cos\(.*\+}}
// CHECK: output[4] =
// VERIFIED: kernel model, mode fast: 1000 samples
// WITHOUT: void compute(
// WITHOUT-NOT: {{pow|/ constants}}
// WITHOUT: output[4] =
