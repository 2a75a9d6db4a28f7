// A function of the program may compute with what it takes through `...`: a truth value there is a decision.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdarg>
#include <cstdio>

int count(int n, ...) {
  va_list list;
  va_start(list, n);
  int sum = 0;
  for (int i = 0; i < n; i++) sum += va_arg(list, int);
  va_end(list);
  return sum;
}

#pragma symreal function input(x, y) constant(n) output(return)
double vote(double x, double y, int n) { return x * count(n, x > 0, y > 0); }

int main() { std::printf("%g\n", vote(0.5, 2.0, 2)); }

// CHECK-DAG: truth_through_ellipsis.cpp:17:{{[0-9]+}}: error: the program decides on a symbolic value: x > 0 (met 1 time) [SYM016]
// CHECK-DAG: truth_through_ellipsis.cpp:17:{{[0-9]+}}: error: the program decides on a symbolic value: y > 0 (met 1 time) [SYM016]
