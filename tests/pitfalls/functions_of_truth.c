/* A function of the library is given the truth value of a comparison, and an integer starts with a fraction. */
// RUN: %symreal generate %s -o %t.c --decisions=select && FileCheck %s --input-file=%t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c
// RUN: cp %s %t.cpp && %symreal generate %t.cpp -o %t2.c --decisions=select && %symreal verify --samples=100 --min-samples=10 %t.cpp %t2.c
#include <math.h>
#include <stdlib.h>

// CHECK: input[0] + (input[0] > 1.0 ? 1.0 : 0.0);
// CHECK: expm1(at_run(input[0] < input[1] ? 1.0 : 0.0));
// CHECK: input[1] + to_int32(input[0]*2.5);
#pragma symreal function input(x[0:2]) range(-4, 4) output(y[0:3])
void kernel(double const *x, double *y)
{
    int whole = 0.25;
    y[0] = x[0] + abs(x[0] > 1.0);
    y[1] = expm1(x[0] < x[1]);
    whole = 2.5 * x[0];
    y[2] = x[1] + whole;
}

int main(void)
{
    double x[2] = {1.5, 0.25}, y[3];
    kernel(x, y);
    return 0;
}
