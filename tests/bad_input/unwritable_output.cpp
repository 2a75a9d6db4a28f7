// The output stands in a directory that does not exist.
// RUN: not %symreal generate %s -o %t.no-such-directory/y.c 2>&1 | FileCheck %s
// RUN: not ls %t.no-such-directory

#include <cmath>
#include <cstdio>

int main() {
  double x = 0.5;
#pragma symreal input(x)
  double y = std::sin(x);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: error: {{.*}}no-such-directory{{.*}}[SYM001]
// CHECK: help:
