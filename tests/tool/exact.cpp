// A stretch that mode fast keeps as it is written: the correction of a compensated sum.
// RUN: %symreal generate %s -o %t.c --fp=fast --effort=1
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
// RUN: FileCheck %s --check-prefix=CODE --input-file=%t.c
// The same without the pragmas.
// RUN: sed '/exact/d' %s > %t.plain.cpp && %symreal generate %t.plain.cpp -o %t.plain.c --fp=fast --effort=1
// RUN: FileCheck %s --check-prefix=PLAIN --input-file=%t.plain.c
// Without the switch nothing of it is left.
// RUN: %rewrite %s | FileCheck %s --check-prefix=TEXT
#include <cstdio>

// TEXT: double two_product_error(
// TEXT: SYMREAL_EXACT
#pragma symreal function exact
static double two_product_error(double a, double b) {
  double const big = 134217729.0 * a, high = big - (big - a), low = a - high;
  double const big_b = 134217729.0 * b, high_b = big_b - (big_b - b), low_b = b - high_b;
  return low * low_b - (((a * b - high * high_b) - low * high_b) - high * low_b);
}

#pragma symreal function input(x[0:4]) output(sum, error, square)
void accurate(double const *x, double &sum, double &error, double &square) {
  double rest = 0;
  sum = 0;
// TEXT: SYMREAL_REAL_EXACT
#pragma symreal exact
  for (int i = 0; i < 4; i++) {
    double const y = x[i] - rest;
    double const t = sum + y;
    rest = (t - sum) - y;
    sum = t;
  }
  error = two_product_error(x[0], x[1]);
  square = (x[0] + x[1]) * (x[0] + x[1]) - x[0] * x[0] - 2 * x[0] * x[1]; // is the square of x[1]
}

int main() {
  double const x[4] = {1, 1e16, 3, -1e16};
  double sum, error, square;
  accurate(x, sum, error, square);
  std::printf("%g %g %g\n", sum, error, square);
}
// CHECK: sum 1 0 0
// CHECK-NEXT: error 1 0 0
// CODE: FP_CONTRACT OFF
// CODE: double const t = input[1] + input[0];
// CODE-NEXT: double const y = input[1] + (input[0] - t) + input[2];
// CODE: 134217729.0
// PLAIN-NOT: 134217729.0
// PLAIN: output[1] = 0.0;
