// Invalid operations of the program's own while a kernel is recorded are no leaks, and have the results that they have.
// RUN: rm -rf %t && mkdir %t
// RUN: %cxx -O1 -fno-builtin -Wno-unknown-pragmas %s -o %t/original && %t/original > %t/expected
// RUN: %symreal generate %s -o %t/a.c --run-on > %t/log 2>&1
// RUN: FileCheck %s --implicit-check-not=SYM < %t/log
// RUN: sed -n 's/^program| //p' %t/log | diff - %t/expected
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/a.c
#include <cfenv>
#include <cmath>
#include <cstdio>

// Passive: none of these depends on an input.
[[gnu::noipa]] static void invalid(double zero) {
  double quotient = zero / zero, root = std::sqrt(zero - 1);
  bool no_quotient = std::isnan(quotient), no_root = std::isnan(root), below = quotient < root;
  std::printf("%d %d %d\n", no_quotient, no_root, below);
  std::printf("%d %d\n", static_cast<int>(1e300 + zero), 1);
  bool no_angle = std::isnan(std::acos(2 + zero)), no_remainder = std::isnan(std::fmod(1.0, zero));
  std::printf("%d %d\n", no_angle, no_remainder);
}

int main() {
  double x = 0.5;
#pragma symreal input(x) range(-3, 3)
  double y = std::sin(x) * x;
  invalid(0);
  y += std::cos(x);
#pragma symreal output(y) generate("a.c")
  std::printf("%g\n", y);
}
// CHECK: program| 1 1 0
// CHECK-NEXT: program| -2147483648 1
