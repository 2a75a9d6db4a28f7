// A decision that cannot be a select is reported with what is in the way; so is a loop beyond its bound.
// RUN: not %symreal generate %s -o %t.c --decisions=select 2>&1 | FileCheck %s
// RUN: not ls %t.c
// CHECK: selects_refused.cpp:17:{{[0-9]+}}: error: the loop is bounded to 2 runs and goes on in this run [SYM049]
#include <cstdio>
int count = 0;
int main() {
  double x = 0.5, y = 1;
#pragma symreal input(x)
  // CHECK: selects_refused.cpp:[[@LINE+2]]:{{[0-9]+}}: error: the program decides on a symbolic value: x > 0 (met 1 time) [SYM016]
  // CHECK: selects_refused.cpp:[[@LINE+1]]:23: note: not selectable: an assignment to 'count', which is not a REAL
  if (x > 0) { y = x; count++; }
  // CHECK-NOT: error:
  if (x > 1) y = 2;
  y += x > 2 ? x : 2;
#pragma symreal loop(2)
  while (x < 100) x *= 3;
  y += x;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
