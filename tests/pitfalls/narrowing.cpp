// A REAL that would be cut to an integer in passing.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdio>

int counter;

#pragma symreal function input(x) constant(counter) output(return)
double cut(double x) {
  int n = 1;
  // CHECK-DAG: narrowing.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the result is a REAL and is converted to int [SYM034]
  n += x;
  // CHECK-DAG: narrowing.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the result is a REAL and is converted to int [SYM034]
  counter *= 2.0 * x;
  return n + x;
}

int main() { std::printf("%g\n", cut(1.5)); }
