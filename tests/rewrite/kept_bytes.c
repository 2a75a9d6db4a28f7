/* One allocation for numbers and integers: the run tells that no number is read as an integer, or a comment does. */
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
// CHECK: y {{ *}}1 {{ *}}0 {{ *}}0
// RUN: %symreal generate %s -o %t.c -- -DUNKEPT && %symreal verify --samples=100 --min-samples=10 %s %t.c -- -DUNKEPT 2>&1 | FileCheck %s
#include <stdio.h>
#include <stdlib.h>

static double reordered(int n, double const *x)
{
    double *sum = malloc(n * sizeof(double) + n * sizeof(int)), *last, result = 0;
    int i, *order;
    last = (double *)((char *)sum + (n - 1) * sizeof *sum); // counts in bytes, and looks at none
#ifdef UNKEPT
    order = (int *)(sum + n);
#else
    order = (int *)(sum + n); // symreal: keep
#endif
    for (i = 0; i < n; ++i) order[i] = n - 1 - i;
    for (i = 0; i < n; ++i) sum[i] = x[order[i]] * (i + 1);
    for (i = 0; i < n; ++i) result += sum[i] * *last;
    free(sum);
    return result;
}

int main(void)
{
    double x[3] = {1, 2, 3}, y;
#pragma symreal input(x)
    y = reordered(3, x);
#pragma symreal output(y) generate("y.c")
    printf("%g\n", y);
    return 0;
}
