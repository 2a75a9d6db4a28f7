/* min and max by a macro, of a plain integer and of one that was made of a number. */
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
// CHECK: y {{ *}}1 {{ *}}0 {{ *}}0
// RUN: %rewrite %s | FileCheck %s --check-prefix=TEXT
#include <math.h>
#include <stdio.h>

// TEXT: #define MAX(a, b) (REAL_COND((a) > (b)) REAL_THEN (a) REAL_ELSE (b) REAL_END)
#define MAX(a, b) ((a) > (b) ? (a) : (b))
#define MIN(a, b) ((a) < (b) ? (a) : (b))

static double f(double x, int n, double const *t)
{
    int low = MAX(0, (int)floor(MIN(x, 2.0)) - 1);
    int high = MIN(n - 1, (int)ceil(x) + 1);
    return t[low] + t[high] * x + MAX(n, 2);
}

int main(void)
{
    double x = 1.5, y, t[4] = {1, 2, 3, 4};
#pragma symreal input(x) range(0.1, 1.9)
#pragma symreal constant(t)
    y = f(x, 4, t);
#pragma symreal output(y) generate("y.c")
    printf("%g\n", y);
    return 0;
}
