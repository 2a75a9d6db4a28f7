// Functions of the mathematical library take an integer that was made of a number as they take any: as a number.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && FileCheck %s --input-file=%t.c && %symreal verify %s %t.c --samples=200
#include <cmath>
#include <cstdio>
#include <cstdlib>

#pragma symreal function input(x) range(0, 50) output(y[0:3])
void kernel(double x, double *y) {
  int k = (int)x;
  unsigned n = (unsigned)(x + 1);
  // CHECK-DAG: sqrt(
  y[0] = std::sqrt(k) + sqrt(n) + std::floor(k) + fabs(k);
  // CHECK-DAG: pow(
  y[1] = std::pow(k, 0.5) + std::pow(x, n) + std::atan2(k, n) + hypot(k, 3);
  y[2] = std::fabs(k - 7) / 2 + std::sin(k % 5);
}

int main() {
  double y[3];
  kernel(5.3, y);
  std::printf("%g %g %g\n", y[0], y[1], y[2]);
}
