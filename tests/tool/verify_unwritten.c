/* An output that the original does not write keeps what its caller has there. verify sees that in the calls in a row, before
   each of which something else is put there. What differs here does so by the switches of the builds.
   RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c
   RUN: not %symreal verify --samples=100 --min-samples=10 %s %t.c -- -DKEEPS 2>&1 | FileCheck %s
   RUN: cp %s %t.cpp && %symreal generate %t.cpp -o %t.k.c && %symreal verify --samples=100 --min-samples=10 %t.cpp %t.k.c
   RUN: not %symreal verify --samples=100 --min-samples=10 %t.cpp %t.k.c -- -DKEEPS 2>&1 | FileCheck %s
   CHECK: error: called again, 1 of 6 outputs differ from the original: it keeps something other than its outputs
   CHECK: note: y[1]: original
*/
#include <stdio.h>

#if defined(KEEPS) && !defined(MBD_SYMBOLIC) && !defined(MBD_REPLAY)
#define WRITES 0
#else
#define WRITES 1
#endif

struct limits { double low, high; };

#pragma symreal function input(x, sum[0:1]) constant(y[2]) output(y[0:3], l->low, sum[0:1], return)
double hold(double x, double *sum, double *y, struct limits *l)
{
    y[0] = 2 * x;
    if (WRITES) y[1] = 4;
    l->low = x - 1;
    sum[0] += 0.25 * x;
    return x * x;
}

int main(void)
{
    double sum[1] = {0.5}, y[3] = {0, 4, 7}; /* y[2] is said to stay */
    struct limits l = {1, 2};
    printf("%g %g %g\n", hold(1.5, sum, y, &l), y[0], l.low);
    return 0;
}
