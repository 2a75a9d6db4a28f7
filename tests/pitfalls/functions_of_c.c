/* A function of C takes a double, an int, whatever it is given; C++ has another for each type. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %cc %s -o %t.orig -lm && %symreal-cc %s -o %t.exe -lm && %t.orig > %t.plain && %t.exe | diff %t.plain -
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static double all(double x)
{
    float f = 0.3f;
    long double l = 0.1L;
    long wide = -4294967297;
    // CHECK: x + sin(REAL_PROMOTED(f)) + sqrt(REAL_PROMOTED(l)) + pow(x, REAL_PROMOTED(f)) + ldexp(REAL_PROMOTED(f), 2);
    double y = x + sin(f) + sqrt(l) + pow(x, f) + ldexp(f, 2);
    // CHECK: y += abs((int)(wide)) + abs((int)(-2.5)) + sinf(f);
    y += abs(wide) + abs(-2.5) + sinf(f);
    // CHECK: y += REAL_BUILTIN(exp)(REAL_PROMOTED(f)) + fabs(-2) + fmax(x, 3);
    y += __builtin_exp(f) + fabs(-2) + fmax(x, 3);
    return y;
}

int main(void)
{
    printf("%.17g %.17g\n", all(1.3), atan2(0.1f, 0.3f));
    return 0;
}
