// What the caller gives to const parameters are inputs like others.
// RUN: %symreal generate %s -o %t.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c -- -O2 2>&1 | FileCheck %s
#include <cstdio>

#pragma symreal function input(x[0:2], d, table[0:2]) parameter(m) output(y[0:2])
void kernel(double const *const x, double const d, double const (&table)[2], const double m, double *const y) {
  y[0] = x[0] * d + m;
  y[1] = x[1] - d * table[1];
}

static double const fixed[2] = {0.25, 4};

int main() {
  double y[2];
  kernel(fixed, 3, fixed + 0 == fixed ? *reinterpret_cast<double const (*)[2]>(new double[2]{1, 2}) : fixed, 5, y);
  std::printf("%g %g\n", y[0], y[1]);
}

// CHECK: 100 within the premises
// CHECK: y[0]{{ +}}2{{ +}}0{{ +}}0
