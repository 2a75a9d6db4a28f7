// An input met again before generate: is the loop part of the kernel, or the kernel part of the loop?
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

int main() {
  double x = 0.5, y = 0.0;
  for (int i = 0; i < 3; i++) {
#pragma symreal input(x)
    y += std::sin(x);
  }
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: input_twice.cpp:11:{{[0-9]+}}: error: {{.*}}x{{.*}}[SYM050]
// CHECK: help:
