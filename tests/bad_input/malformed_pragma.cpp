// A clause whose parenthesis is never closed.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

int main() {
  double x[3] = {0.5, 1.0, 1.5};
#pragma symreal input(x[0:3]
  double y = std::sin(x[0]) * x[1] + x[2];
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: malformed_pragma.cpp:10:{{[0-9]+}}: error: {{.*}}[SYM021]
// CHECK: help:
