// A test of a computed number for exact zero is taken as not met, and a guard refuses the zero, unless --explore=zeros=explore asks
// for its path. An input that is compared with 0 may be a mode: both paths are recorded.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/guard.c --decisions=explore --explore=joins=off 2>&1 | FileCheck %s --check-prefix=GUARD
// GUARD-NOT: warning
// GUARD: explored 2 paths, 1 select between them; complete but for exact zeros: see the guards
// GUARD: 3 tests for exact zero taken as not met
// GUARD-NEXT: guard 1 exact_zeros.cpp:[[#@LINE+19]]:5: determinant != 0 ({{.*}}) where mode == 0
// GUARD-NEXT: guard 2 exact_zeros.cpp:[[#@LINE+21]]:3: sum <= DBL_MIN ({{.*}}) is false{{$}}
// GUARD-NOT: guard {{[0-9]}}
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/guard.c 2>&1 | FileCheck %s --check-prefix=SAME
// RUN: %symreal generate %s -o %t/explore.c --decisions=explore --explore=joins=off --explore=zeros=explore 2>&1 | FileCheck %s --check-prefix=EXPLORE
// EXPLORE: complete: no guards
// RUN: FileCheck %s --check-prefix=TEXT < %t/explore.c
// TEXT: "decisions":"explore:128:64:zeros:apart"
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/explore.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: value_return 1 0 0{{$}}
#include <cfloat>
#include <cmath>
#include <cstdio>

#pragma symreal function input(x[0:2], y[0:2], mode) output(return)
double f(double const *x, double const *y, double mode) {
  double a = x[0];
  if (mode == 0) {
    double const determinant = x[0] * y[1] - x[1] * y[0];
    if (determinant != 0) a /= determinant;
  }
  double const sum = std::fabs(y[0]) + std::fabs(y[1]);
  if (sum <= DBL_MIN) return 0;
  return a / sum;
}

int main() {
  double x[2] = {1, 2}, y[2] = {3, 5};
  std::printf("%g\n", f(x, y, 0));
}
