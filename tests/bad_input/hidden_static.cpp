// The same, hidden in a function.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

#pragma symreal function input(sample) output(return)
double smooth(double sample) {
  static double previous = 0.0;
  previous = 0.75 * previous + 0.25 * sample;
  return previous;
}

int main() {
  for (int i = 1; i <= 3; i++) std::printf("%g\n", smooth(i));
}

// CHECK: hidden_static.cpp:10:{{[0-9]+}}: error: {{.*}}previous{{.*}}[SYM053]
// CHECK: help:
