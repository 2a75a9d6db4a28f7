// The compiler that is to build the symbolic program does not exist.
// RUN: not %symreal generate %s --cxx=no-such-compiler -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

int main() {
  double x = 0.5;
#pragma symreal input(x)
  double y = std::sin(x);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: error: {{.*}}no-such-compiler{{.*}}[SYM004]
// CHECK: help:
