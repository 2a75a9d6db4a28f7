// A choice between integers that is an arm of another: what is selected within makes a select of the choice around it.
// RUN: rm -rf %t && mkdir %t && cp %s %t/k.c
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s
// RUN: %symreal generate %s --decisions=guard -o %t/k_cpp.c && %symreal verify --samples=100 %s %t/k_cpp.c --min-samples=1
// RUN: %symreal generate %t/k.c --decisions=guard -o %t/k_c.c && %symreal verify --samples=100 %t/k.c %t/k_c.c --min-samples=1
#include <stdio.h>

#pragma symreal function input(x[0:4]) range(-8.0, 8.0) output(y[0:3])
void k(double const *x, double *y) {
  int const n = (int)x[1];
  // CHECK: x[REAL_COND(n < 0) REAL_THEN 0 REAL_ELSE REAL_COND(n > 3) REAL_THEN 3 REAL_ELSE REAL_TO(int, n) REAL_END REAL_END]
  y[0] = x[n < 0 ? 0 : n > 3 ? 3 : n];
  // CHECK: x[REAL_COND(n > 2) REAL_THEN 1 REAL_ELSE (REAL_COND(n < -1) REAL_THEN REAL_TO(int, n & 3) REAL_ELSE 2 REAL_END) REAL_END]
  y[1] = x[n > 2 ? 1 : (n < -1 ? n & 3 : 2)];
  // CHECK: x[n > 1 ? 0 : n < 0 ? 2 : 1]
  y[2] = x[n > 1 ? 0 : n < 0 ? 2 : 1];
  int count = 2;
  // CHECK: (REAL_COND(count < 3) REAL_THEN REAL_COND({{.*}} < 5) REAL_THEN -255 REAL_ELSE 4 REAL_END REAL_ELSE 3 REAL_END)
  y[2] += 1.0 + (count < 3 ? x[0] < 5 ? -255 : 4 : 3);
}

int main(void) {
  double x[4] = {0.5, 2.5, -1.25, 3}, y[3];
  k(x, y);
  printf("%g %g %g\n", y[0], y[1], y[2]);
  return 0;
}
