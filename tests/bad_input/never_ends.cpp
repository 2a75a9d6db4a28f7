// The program does not get to its kernel in time.
// RUN: not %symreal generate %s --timeout=2 -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

int main() {
  double x = 0.5;
  for (volatile bool forever = true; forever;) {}
#pragma symreal input(x)
  double y = std::sin(x);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: never_ends.cpp:11:{{[0-9]+}}: error: {{.*}}[SYM008]
// CHECK: help:
