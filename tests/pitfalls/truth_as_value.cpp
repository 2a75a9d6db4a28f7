// A comparison beside a plain truth value in ?:, in a stream, in an assignment.
// RUN: %same %s
// RUN: %symreal generate %s --decisions=guard -o %t.c && FileCheck %s < %t.c
// RUN: %symreal verify %s %t.c --samples=100 --min-samples=20
#include <cmath>
#include <iostream>

// CHECK: if (!({{.*}} > input[1])) return 1;
#pragma symreal function input(x, y) range(-1, 1) constant(known) output(return)
double kernel(double x, bool known, double y) {
  bool const above = known ? x > y : std::signbit(y) || y == 2;
  auto below = x < y;
  std::clog << "above " << (x > y) << "\n";
  below = !above;
  if (below) return -x;
  return x;
}

int main() {
  std::cout << kernel(0.5, true, 0.25) << "\n";
  std::cout << kernel(0.5, false, 0.25) << "\n";
}
