// Guards of one kernel after another: the memory in which the recording keeps them is no memory of the program.
// RUN: rm -rf %t && mkdir %t && %symreal generate %s -o %t/ --decisions=guard 2>&1 | FileCheck %s --implicit-check-not="error:"
// RUN: %symreal verify %s %t/many.c %t/one.c --samples=100 --min-samples=10
// CHECK: kernel many
// CHECK: kernel one
#include <stdio.h>

static const double table[32] = {0.5, 1, 2, 3, 5, 8, 13, 21, 34, 55};

#pragma symreal function input(x[0:6]) range(0.0, 30.0) output(return)
double many(const double *x) {
  return table[(int)x[0]] + table[(int)x[1]] + table[(int)x[2]] + table[(int)x[3]] + table[(int)x[4]] + table[(int)x[5]] +
         table[(int)(0.5 * x[0])] + table[(int)(0.5 * x[1])] + table[(int)(0.5 * x[2])] + table[(int)(0.5 * x[3])];
}

#pragma symreal function input(x) range(0.0, 1.5) output(return)
double one(double x) {
  if (x > 2) return x;
  return x < 1 ? 2 * x : 3 * x;
}

int main(void) {
  double const x[6] = {1, 2, 3, 4, 5, 6};
  printf("%g\n", many(x));
  printf("%g\n", one(0.5));
}
