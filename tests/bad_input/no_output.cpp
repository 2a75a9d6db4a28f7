// A kernel without any output computes nothing.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

int main() {
  double x = 0.5;
#pragma symreal input(x)
  double y = std::sin(x);
#pragma symreal generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: no_output.cpp:12:{{[0-9]+}}: error: {{.*}}output{{.*}}[SYM028]
// CHECK: help:
