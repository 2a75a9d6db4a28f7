// An output that depends on no input is most likely not what was meant.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

int main() {
  double x = 0.5;
#pragma symreal input(x)
  double y = std::sin(x), z = std::sin(0.5);
#pragma symreal output(y, z) generate("y.c")
  std::printf("%g %g\n", y, z);
}

// CHECK: constant_output.cpp:12:{{[0-9]+}}: error: {{.*}}z{{.*}}[SYM051]
// CHECK: help:
