// A truth value is compared with an integer that was made of a number as an int is.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c --decisions=guard && FileCheck %s --input-file=%t.c
// RUN: %symreal verify %s %t.c --samples=200 --min-samples=20
#include <cstdio>

#pragma symreal function input(x, y) range(0, 3) output(return)
double kernel(double x, double y) {
  int const one = static_cast<long long>(x) <= (x > y), two = (y > 1) == static_cast<int>(x);
  // CHECK: to_int64(input[0]) <= 0.0
  // CHECK: to_int32(input[0]) == 1.0
  return x + 0.5 * one + 0.25 * two + ((x > 2) != static_cast<unsigned>(y) ? y : 0);
}

int main() { std::printf("%g\n", kernel(0.5, 2.0)); }
