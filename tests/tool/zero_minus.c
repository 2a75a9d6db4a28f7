/* gcc 12 takes 0.0 - fabs(x) + y for y - fabs(x), which is -0 at x = 0, y = -0: what is taken from zero has a statement
   of its own. */
// RUN: %symreal generate %s -o %t.c --fp=strict && FileCheck %s < %t.c
// CHECK: double const [[SIZE:.*]] = fabs(
// CHECK: 0.0 - [[SIZE]]
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c
#include <math.h>
#include <stdio.h>

#pragma symreal function input(x[0:2]) output(return)
double remaining(double const x[2])
{
    double rest = 0;
    rest -= fabs(x[0]);
    return rest + x[1];
}

int main(void)
{
    double x[2] = {1, 2};
    printf("%g\n", remaining(x));
    return 0;
}
