// The exponent of a number is that of the recorded call, under a guard; the class of a number is decided on; and ldexp is
// right where one power of two would overflow or vanish.
// RUN: %same %s
// RUN: %symreal generate %s --decisions=guard -o %t.c 2>&1 | FileCheck %s --check-prefix=SAID
// RUN: FileCheck %s --input-file=%t.c && %symreal verify %s %t.c --samples=400
// RUN: %symreal generate %s --decisions=guard --fp=strict -o %t.c && %symreal verify %s %t.c --samples=400
// RUN: not %symreal generate %s --decisions=select -o %t.c 2>&1 | FileCheck %s --check-prefix=SELECT
// SAID: guard {{.*}} the exponent of {{.*}} gives 2
// SELECT: error: the program decides on a symbolic value: the exponent of {{.*}} [SYM016]
#include <math.h>
#include <stdio.h>

#pragma symreal function input(x) range(3.6, 6) input(y) range(0.9, 2.1) output(result[0:5])
void kernel(double x, double y, double *result) {
  int e = 0;
  result[0] = frexp(x, &e);
  result[1] = result[0] * e + ilogb(y);
  // CHECK-DAG: 0.125
  result[2] = (isnormal(x - 3) ? x : 2 * x) + (fpclassify(y) == FP_NORMAL ? y : 7);
  result[3] = ldexp(ldexp(x, -1060), 1070) + ldexp(y * 1e-300, 1030);
  result[4] = ldexp(y * 1e300, -1080) * 0x1p1000 + ldexp(x, -5000) + scalbn(y * 0x1p-1060, 2070);
}

int main(void) {
  double result[5];
  kernel(5.3, 1.9, result);
  printf("%g %g %g %g %g\n", result[0], result[1], result[2], result[3], result[4]);
  return 0;
}
