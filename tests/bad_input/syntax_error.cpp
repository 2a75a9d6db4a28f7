// A source that does not compile is not rewritten.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

int main() {
  double x = 0.5;
#pragma symreal input(x)
  double y = std::sin(x;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: syntax_error.cpp:11:{{[0-9]+}}: error: {{.*}}expected ')'{{.*}}[SYM020]
// CHECK: help:
