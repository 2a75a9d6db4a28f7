// A number as a truth value: the comparison with 0 that the language makes is a decision.
// RUN: rm -f %t.c
// RUN: %same %s
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify --samples=100 %s %t.c --min-samples 1
#include <cassert>
#include <cstdio>

#pragma symreal function input(x, y) output(return)
double count(double x, double y) {
  double n = x + y;
  // CHECK-DAG: conditions.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: x (met 1 time)
  if (x) n += 1.0;
  // CHECK-DAG: conditions.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: {{.*}}y (met 1 time)
  if (!y) n += 2.0;
  // CHECK-DAG: conditions.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: {{.*}} < 8
  while (n && n < 8.0) n *= 2.0;
  assert(n);
  return n;
}

int main() { std::printf("%g\n", count(1.5, 0.75)); }
