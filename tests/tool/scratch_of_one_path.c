/* A static integer that the recorded path writes before it reads it is scratch where no guard stands, though the source has a path
   that reads it first: the baked-in argument excludes that path. */
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: %symreal verify %s %t.c --samples=50
// CHECK-NOT: error
// CHECK: kernel kernel: 1 inputs
#include <stdio.h>

#pragma symreal function input(x) constant(n) output(return)
double kernel(double x, int n)
{
    static int factor;
    if (n > 0) factor = 3;
    return factor * x;
}

int main(void) { printf("%g\n", kernel(0.7, 1)); return 0; }
