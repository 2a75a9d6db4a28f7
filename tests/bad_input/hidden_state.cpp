// State that survives the kernel: read, written, and named in no pragma.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

static double travelled = 0.0;

#pragma symreal function input(step) output(return)
double travel(double step) {
  travelled += std::fabs(step);
  return travelled;
}

int main() {
  for (int i = 1; i <= 3; i++) std::printf("%g\n", travel(0.5 * i));
}

// CHECK: hidden_state.cpp:8:{{[0-9]+}}: error: {{.*}}travelled{{.*}}[SYM053]
// CHECK: help:
