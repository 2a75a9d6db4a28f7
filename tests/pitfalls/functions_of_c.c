/* A function of C takes a double, an int, whatever it is given; C++ has another for each type. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %cc %s -o %t.orig -lm && %symreal-cc %s -o %t.exe -lm && %t.orig > %t.plain && %t.exe | diff %t.plain -
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { count = 3 };
// CHECK: #define TWICE(function, x) (2 * function(x))
#define TWICE(function, x) (2 * function(x))

static double all(double x)
{
    float f = 0.3f;
    long double l = 0.1L;
    long wide = -4294967297;
    // CHECK: x + sin(REAL_PROMOTED(f)) + sqrt(REAL_PROMOTED(l)) + pow(x, REAL_PROMOTED(f)) + ldexp(REAL_PROMOTED(f), 2);
    double y = x + sin(f) + sqrt(l) + pow(x, f) + ldexp(f, 2);
    // CHECK: y += abs((int)(wide)) + abs((int)(-2.5)) + sinf(f);
    y += abs(wide) + abs(-2.5) + sinf(f);
    // CHECK: y += REAL_BUILTIN(exp)(REAL_PROMOTED(f)) + fabs(REAL_PROMOTED(-2)) + fmax(x, 3);
    y += __builtin_exp(f) + fabs(-2) + fmax(x, 3);
    // Of integers C++ has templates, which the compiler folds otherwise than the library rounds.
    // CHECK: y += expm1(REAL_PROMOTED(1)) + cbrt(REAL_PROMOTED(10)) + log1p(REAL_PROMOTED('\2')) + erf(REAL_PROMOTED(2));
    y += expm1(1) + cbrt(10) + log1p('\2') + erf(2);
    // CHECK: y += pow(REAL_PROMOTED(3), 0.3) + tgamma(REAL_PROMOTED(abs(-7)));
    y += pow(3, 0.3) + tgamma(abs(-7));
    // CHECK: y += cbrt(REAL_PROMOTED(wide * 2)) + pow(x, 2) + TWICE(cosh, REAL_PROMOTED(3));
    y += cbrt(wide * 2) + pow(x, 2) + TWICE(cosh, 3);
    return y;
}

int main(void)
{
    printf("%.17g %.17g\n", all(1.3), atan2(0.1f, 0.3f));
    return 0;
}
