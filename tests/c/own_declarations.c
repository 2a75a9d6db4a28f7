/* A program may declare the functions of <math.h> itself. */
// RUN: %rewrite %s -- | FileCheck %s
// RUN: %same %s --
// RUN: %rewrite %s -- > %t.rewritten.c && %rewrite %t.rewritten.c -- | diff %t.rewritten.c -
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>

// CHECK: REAL REAL_EITHER((fabs), symreal_fabs)(REAL), REAL_EITHER((sqrt), symreal_sqrt)(REAL x);
double fabs(double), sqrt(double x);
// CHECK: extern REAL REAL_EITHER((sin), symreal_sin) REAL_PROTOTYPE((REAL), ());
extern double sin();
// What the program defines is its own.
// CHECK: static REAL REAL_NAME(cbrt)(REAL x)
static double cbrt(double x) { return x * x * x; }

int main(void)
{
    double x = 0.5, y;
#pragma symreal input(x) range(-2, 2)
    y = fabs(x) + sqrt(4 * x * x) * sin(x) + cbrt(x);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
