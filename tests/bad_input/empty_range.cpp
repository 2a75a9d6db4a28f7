// A range that ends below where it begins has no values to draw.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdio>

// CHECK: empty_range.cpp:[[@LINE+1]]:32: error: the range of 'a' ends below where it begins [SYM147]
#pragma symreal function input(a) range(1, -1) output(return)
double f(double a) { return a * a; }

int main() { std::printf("%g\n", f(0.5)); }
