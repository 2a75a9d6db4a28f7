// A variable that is kept a double may be an operand of assembly, if both lines say so.
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
// REQUIRES: x86_64-linux
// CHECK: y {{ *}}1 {{ *}}0 {{ *}}0
#include <cstdio>

static double ticks() {
  long const count = 12;
  double result; // symreal: keep
  asm("fildll %1; fstpl %0" : "=m"(result) : "m"(count)); // symreal: keep
  return result;
}

int main() {
  double x = 2;
#pragma symreal input(x)
  double const y = x * ticks();
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
