// No pragma: there is nothing to generate.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
double twice(double x) { return 2 * x; }
int main() { return twice(0.5) > 2; }

// CHECK: no_kernel.cpp: error: {{.*}} [SYM012]
// CHECK: help:
