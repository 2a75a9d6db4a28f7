// std::max<long>(i, x > 1): a comparison as an integer of a type that is said.
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify --samples=100 --min-samples=10 %s %t.c
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
#include <algorithm>
#include <cstdio>

int main() {
  double x = 1.5, y;
  int const i = 0;
  long const j = 4;
#pragma symreal input(x) range(1.1, 1.9)
  // CHECK: std::min<long>(i, j) + std::max<long>(i, REAL_TO(long, x > 1))
  y = static_cast<double>(std::min<long>(i, j) + std::max<long>(i, x > 1)) + std::min<double>(i, x) * x;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
