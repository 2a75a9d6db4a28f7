// errno of what has nothing to do with the numbers is read as in the original.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: %symreal verify %s %t.c --samples=100 --min-samples=50
// CHECK: kernel scaled
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#pragma symreal function input(x) output(return)
double scaled(double x) {
  double const y = std::exp(x) + std::sqrt(x * x);
  errno = 0;
  double const gain = std::strtod("2.5", nullptr);
  if (errno != 0) return 0;
  std::FILE *const file = std::fopen("/nonexistent/file", "r");
  if (!file && errno != ENOENT) return 1;
  return x * gain + y;
}

int main() { std::printf("%g\n", scaled(2.0)); }
