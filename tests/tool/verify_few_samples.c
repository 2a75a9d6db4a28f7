// Inputs that leave the premises of the mode prove nothing: here the root is none of a number.
// RUN: %symreal generate %s -o %t.c
// RUN: not %symreal verify %s %t.c --samples 200 2>&1 | FileCheck %s
#include <math.h>
#pragma symreal function input(x) range(-2, -1) output(return)
double root(double x) { return sqrt(x); }
int main(void) { return root(-1.5) > 1; }
// CHECK: verify_few_samples.c{{.*}}: error: only {{[0-9]+}} samples lie within the premises of mode finite, and {{[0-9]+}} are required [SYM092]
// CHECK: help: give the inputs a range(low, high) in their pragma
