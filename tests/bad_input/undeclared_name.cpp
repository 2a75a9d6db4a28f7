// A pragma names what the source does not declare.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

int main() {
  double x = 0.5;
#pragma symreal input(x, velocity)
  double y = std::sin(x);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: undeclared_name.cpp:10:{{[0-9]+}}: error: {{.*}}velocity{{.*}}[SYM023]
// CHECK: help:
