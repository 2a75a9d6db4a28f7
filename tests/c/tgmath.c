/* <tgmath.h>: macros in C, overloaded functions in C++. */
// RUN: %rewrite %s -- | FileCheck %s
// RUN: %same %s --
// RUN: %symreal generate %s -o %t.c && FileCheck %s --input-file=%t.c --check-prefix=OUT
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// OUT: sqrt(input[0])
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>
#include <tgmath.h>

int main(void)
{
    double x = 0.5, y;
    float f = 0.25f;
    int n = 2;
#pragma symreal input(x) range(0.1, 2)
    // CHECK: y = sqrt(x) + sin(x)
    y = sqrt(x) + sin(x) * pow(x, n) - fabs(-x) + fmax(x, n) + (double)sqrt(f) + ldexp(x, n) + atan2(f, x);
    y += (double)fma(x, x, f) + floor(sqrt(n) * x) + lrint(2.5f);
#pragma symreal output(y) generate("y.c")
    printf("%.17g %d %d\n", y, (int)sizeof(sqrt(f)), (int)sizeof(pow(f, n)));
    return 0;
}
