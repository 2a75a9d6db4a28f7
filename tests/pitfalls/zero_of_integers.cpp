// Integers have one zero: a conversion, a product, a quotient, a remainder and a truth value never give -0, which mode
// strict sees.
// RUN: rm -rf %t && mkdir %t
// RUN: %same %s
// RUN: %symreal generate %s --decisions=select --fp=strict --mainline -o %t/k.c
// RUN: %symreal verify %s %t/k.c --samples=500 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y[0] {{ *}}7 {{ *}}0 {{ *}}0{{$}}
// RUN: %cxx -w %s -o %t/original && %cc %t/k.c %t/k_main.c -lm -o %t/run
// RUN: %t/original -0.5 > %t/expected && %t/run -0.5 | diff %t/expected -
// RUN: FileCheck %s < %t/expected
// RUN: %t/original -6.5 > %t/expected && %t/run -6.5 | diff %t/expected -
#include <cmath>
#include <cstdio>
#include <cstdlib>

#pragma symreal function input(x) range(-8, 8) output(y[0:7])
void k(double x, double *y) {
  int i = (int)x, j = (int)(x * 10);
  // CHECK: y[0] = 0
  y[0] = i;
  // CHECK: y[1] = 1
  y[1] = copysign(1.0, (double)(i * j));
  y[2] = copysign(1.0, (double)(i / 100));
  y[3] = copysign(1.0, (double)(j % 3));
  y[4] = copysign(1.0, (double)-i);
  long l = lround(x * 0.1);
  y[5] = copysign(1.0, (double)(l * j));
  // CHECK: y[6] = 1
  y[6] = copysign(1.0, (double)-(x > 0));
}

int main(int, char **arguments) {
  double y[7];
  k(arguments[1] ? atof(arguments[1]) : -0.5, y);
  for (int i = 0; i < 7; ++i) printf("y[%d] = %.17g\n", i, y[i]);
}
