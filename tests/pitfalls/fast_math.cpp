// Flags that let a compiler take liberties with numbers are left out where the program records itself.
// RUN: %symreal generate %s -o %t.c -- -Ofast -ffast-math && %symreal verify %s %t.c --samples=100 -- -Ofast -ffast-math
// RUN: FileCheck %s --input-file=%t.c
#include <cstdio>

// CHECK: input[0] + input[1] - input[1]
#pragma symreal function input(x, y) output(return)
double rounded(double x, double y) { return (x + y) - y; }

int main() { std::printf("%g\n", rounded(0.1, 1e9)); }
