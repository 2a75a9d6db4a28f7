// A class that converts to double: its objects are operands of signs and conditions too.
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
// RUN: %rewrite %s | FileCheck %s --check-prefix=TEXT
// RUN: %same %s
// CHECK: y {{ *}}1 {{ *}}0 {{ *}}0
#include <cstdio>

struct Quantity {
  double value;
  operator double() const { return value; }
};
static double twice(double x) { return 2 * x; }

int main() {
  double x = 0.5, y;
#pragma symreal input(x) range(0.1, 0.9)
  Quantity const q{x};
  // TEXT: y = q * 2 + 2 * q + {{.*}} - -REAL_TO(REAL, q)
  y = q * 2 + 2 * q + q * q - -q + twice(q) + q / 0.5 - +q;
  y += q > 0.3 ? q : 1.0;
  // TEXT: if (!REAL_TO(REAL, q)) y = 3;
  if (!q) y = 3;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
