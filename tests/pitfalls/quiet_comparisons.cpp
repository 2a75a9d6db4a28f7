// The comparisons of <cmath> that raise no flag.
// RUN: %symreal generate %s -o %t.c --decisions=select && FileCheck %s < %t.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=VERIFY
// CHECK: input[0] > input[1]
// VERIFY: y[0] {{ *}}3 {{ *}}0 {{ *}}0
#include <cmath>
#include <cstdio>

int main() {
  double x[2] = {0.5, 1.5}, y[3];
#pragma symreal input(x) range(-1, 1)
  y[0] = std::isgreater(x[0], x[1]) ? x[0] : x[1];
  y[1] = std::isless(x[0], 0.5) ? 1.0 : x[0];
  y[2] = std::islessequal(x[0], x[1]) ? x[1] * 2 : x[0] * 3;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y[0]);
}
