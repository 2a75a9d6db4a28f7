/* A static array of integers that a loop writes before the kernel reads it is scratch where no guard stands: the recorded path
   tells that the loop has written what is read. */
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: %symreal verify %s %t.c --samples=50
// CHECK-NOT: error
// CHECK: kernel kernel: 1 inputs
#include <stdio.h>

#pragma symreal function input(x) constant(n) output(return)
double kernel(double x, int n)
{
    static int factors[2];
    for (int i = 0; i < n; i++) factors[i] = 3 + i;
    return factors[1] * x;
}

int main(void) { printf("%g\n", kernel(0.7, 2)); return 0; }
