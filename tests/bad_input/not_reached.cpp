// The program ends before its kernel is recorded.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

int main(int argc, char **) {
  double x = 0.5;
  if (argc < 2) return 0;
#pragma symreal input(x)
  double y = std::sin(x);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: not_reached.cpp:11:{{[0-9]+}}: error: {{.*}}[SYM009]
// CHECK: help:
