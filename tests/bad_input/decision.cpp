// A branch on a value that depends on an input: the other branch would be lost. All decisions are reported.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

double saturate(double x) {
  if (x > 1)
    return 1;
  return x < -1 ? -1 : x;
}

int main() {
  double x = 0.5;
#pragma symreal input(x)
  double y = saturate(std::sin(x));
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: decision.cpp:9:{{[0-9]+}}: error: {{.*}}[SYM016]
// CHECK: decision.cpp:11:{{[0-9]+}}: error: {{.*}}[SYM016]
// CHECK: help:
