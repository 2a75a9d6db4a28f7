// What is computed in long double is not recorded: a REAL does not get there.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdio>

static long double total = 0.0L;

#pragma symreal function input(x) output(return)
double sum(double x) {
  long double y = 1.0L;
  // CHECK-DAG: long_double.cpp:[[@LINE+1]]:{{[0-9]+}}: error: a REAL is converted to long double [SYM036]
  y += x;
  // CHECK-DAG: long_double.cpp:[[@LINE+1]]:{{[0-9]+}}: error: a REAL is converted to long double [SYM036]
  total = x * 2.0;
  // CHECK-DAG: long_double.cpp:[[@LINE+1]]:{{[0-9]+}}: error: a REAL is converted to long double [SYM036]
  return static_cast<double>(y * x + static_cast<long double>(x));
}

int main() { std::printf("%g\n", sum(0.5)); }
