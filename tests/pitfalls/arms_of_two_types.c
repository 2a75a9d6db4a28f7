/* The arms of ?: become integers of one type before that becomes a number: -1 beside an unsigned value is 4294967295. */
// RUN: %symreal generate %s -o %t.c --decisions=select && FileCheck %s --input-file=%t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c
// RUN: %symreal generate %s -o %t.g.c --decisions=guard && %symreal verify --samples=100 --min-samples=10 %s %t.g.c
// RUN: cp %s %t.cpp && %symreal generate %t.cpp -o %t2.c --decisions=select && %symreal verify --samples=100 --min-samples=10 %t.cpp %t2.c
// RUN: %symreal generate %t.cpp -o %t2.g.c --decisions=guard && %symreal verify --samples=100 --min-samples=10 %t.cpp %t2.g.c
// CHECK: t1 ? 1.0 : 4294967295.0
#include <stdio.h>
enum mode { off, on };
static double const table[2] = {1, 2};

#pragma symreal function input(x[0:3]) range(-4, 4) output(y[0:8])
void kernel(double const *x, double *y)
{
    int const minus = -1;
    unsigned const one = 1;
    unsigned char const byte = 200;
    signed char const small = -7;
    long const wide = -5;
    enum mode mode = on;
    y[0] = (table[0] > table[1] ? one : minus) - x[0];
    y[1] = (x[0] > x[1] ? one : minus) - x[0];
    y[2] = (x[0] > x[1] ? wide : one) + x[1];
    y[3] = (x[0] > x[1] ? byte : small) * x[1];
    y[4] = (x[0] > x[1] ? x[1] > x[2] ? one : one + 1 : minus) + x[1];
    y[5] = (x[0] > x[1] ? mode : minus) + x[1];
    y[6] = (x[0] > x[1] ? x[0] > x[2] : minus) + x[2];
    y[7] = (x[0] > x[1] ? minus : 0.5) + x[1];
}

int main(void)
{
    double x[3] = {1.5, 2.5, -3.25}, y[8];
    kernel(x, y);
    printf("%g %g\n", y[0], y[1]);
    return 0;
}
