// A static object that is constant-initialised with double is so with REAL: another source may read it before its own is
// initialised.
// RUN: %same %s %S/Inputs/constants.cpp
// RUN: %symreal generate %s %S/Inputs/constants.cpp -o %t.c && %symreal verify %s %S/Inputs/constants.cpp %t.c --samples=100
// RUN: %symreal generate %S/Inputs/constants.cpp %s -o %t.c && %symreal verify %s %S/Inputs/constants.cpp %t.c --samples=100
// RUN: FileCheck %s --input-file=%t.c
#include <cstdio>

extern double half, root, table[2];
static double const early = half + table[1] + root * 0.0; // while the program starts

// CHECK: = input[0]*-3.5;
#pragma symreal function input(x) output(return)
double scale(double x) { return x * early; }

int main() { std::printf("%g\n", scale(0.5)); }
