// A program that sets the floating-point environment within a kernel would hide leaks.
// REQUIRES: x86_64-linux
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cfenv>

int main() {
  double x = 0.5;
#pragma symreal input(x)
  double y = x * x;
  std::fesetenv(FE_DFL_ENV);
#pragma symreal output(y) generate("y.c")
}
// CHECK: trap_lost.cpp:[[@LINE-2]]:{{[0-9]+}}: error: kernel 'y' changes the floating-point environment {{.*}}[SYM069]
// CHECK: help:
