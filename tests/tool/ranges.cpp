// Each input is sampled in the range that follows it.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/f.c --graph %t/f.graph
// RUN: FileCheck %s --input-file=%t/f.graph
// CHECK: input "a" {{.*}} range 1 2 =
// CHECK: input "b" {{.*}} range 30 40 =
// CHECK: input "c" {{.*}} range 30 40 =
// CHECK: input "d" at "{{[^"]*}}" {{[0-9]+ [0-9]+}} = 5
#include <cstdio>
#pragma symreal function input(a) range(1, 2) input(b, c) range(30, 40) input(d) output(return)
double f(double a, double b, double c, double d) { return a * b + c * d; }
int main() { std::printf("%g\n", f(1.5, 33, 34, 5)); }
