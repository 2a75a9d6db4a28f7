// Default arguments are not part of what a wrapper repeats: 9.81 and ')' are no names.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/k.c --wrapper --decisions=guard 2>/dev/null
// RUN: FileCheck %s < %t/k_wrapper.cpp
// CHECK: double fallback(double x, double g, int n, const char *text);
// CHECK: double kern(double x, double g, int n, const char *text) {
// CHECK: return fallback(x, g, n, text);
// RUN: %cxx -Wall -Wextra -c %t/k_wrapper.cpp -I%t -o %t/k.o
#include <cstdio>

#pragma symreal function input(x) parameter(g) constant(n) output(return)
double kern(double x, double g = 9.81, int n = 3, char const *text = "),(x, 81") {
  if (x > 1) return x * g + n;
  return text ? x - g : 0;
}

int main() { std::printf("%g\n", kern(2)); }
