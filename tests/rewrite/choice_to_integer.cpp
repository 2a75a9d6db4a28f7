// What is chosen by a number is a number, although both of its arms are literals.
// RUN: %symreal generate %s -o %t.c --decisions=select && FileCheck %s < %t.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=VERIFY
// RUN: %symreal generate %s -o %t.guard.c --decisions=guard && %symreal verify --samples=100 --min-samples=10 %s %t.guard.c
// CHECK: input[0] > 0.25
// VERIFY: y {{ *}}1 {{ *}}0 {{ *}}0
// VERIFY: z {{ *}}1 {{ *}}0 {{ *}}0
#include <cstdio>

int main() {
  double x = 0.5, y, z;
#pragma symreal input(x) range(-1, 1)
  int const i = x > 0.25 ? 1 : 2.5;
  y = i * x;
  z = x < 0 ? -1.5 : 2.5;
#pragma symreal output(y, z) generate("yz.c")
  std::printf("%g %g\n", y, x > 0 ? 1.0 : 2.0);
}
