// A misspelt clause is not overlooked.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

int main() {
  double x = 0.5;
#pragma symreal inputs(x)
  double y = std::sin(x);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: unknown_pragma.cpp:10:{{[0-9]+}}: error: {{.*}}inputs{{.*}}[SYM022]
// CHECK: help:
