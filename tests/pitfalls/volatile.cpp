// Volatile numbers, as compensated sums use them against a compiler that reorders: recorded like any other.
// RUN: %same %s
// RUN: %symreal generate %s --fp=strict --decisions=guard -o %t.c && FileCheck %s < %t.c
// RUN: %symreal verify %s %t.c --samples=100 --min-samples=50 2>&1 | FileCheck %s --check-prefix=VERIFY
#include <cstdio>

// CHECK: double const s = input[0] + input[1];
// CHECK: output[1] =
// VERIFY: value_return {{.*}} 0
double sum(double x, double y, double &rest) {
  volatile double s = x + y;
  volatile double up = s - y;
  volatile double down = s - up;
  up -= x;
  down = down - y;
  rest = s != 0 ? 0 - (up + down) : down;
  return s;
}

#pragma symreal function input(x, y) output(return, rest)
double kernel(double x, double y, double &rest) {
  double total = 1;
  volatile double *at = &total;
  *at = x;
  return sum(*at, y, rest);
}

int main() {
  double rest = 0;
  std::printf("%g", kernel(1, 2e-17, rest));
  std::printf(" %g\n", rest);
}
