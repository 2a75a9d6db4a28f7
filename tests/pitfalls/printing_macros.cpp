// A macro that prints its argument, and uses it besides: what is printed is a value, what is used depends as before.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: return {{ *}}1 {{ *}}0 {{ *}}0
#include <cmath>
#include <cstdio>

// CHECK: #define SHOW(e) (std::printf("%g\n", REAL_VALUE(e)), (e))
#define SHOW(e) (std::printf("%g\n", e), (e))
// CHECK: #define TWICE(e) (SHOW(e) + SHOW(2 * (e)))
#define TWICE(e) (SHOW(e) + SHOW(2 * (e)))
// CHECK: #define LOG(...) std::printf(__VA_ARGS__)
#define LOG(...) std::printf(__VA_ARGS__)

#pragma symreal function input(x) output(return)
double f(double x) {
  // CHECK: LOG("%d %g %s\n", 1, REAL_VALUE(x), "text");
  LOG("%d %g %s\n", 1, x, "text");
  // CHECK: REAL y = SHOW(x * 2) + x;
  double y = SHOW(x * 2) + x;
  // CHECK: y += TWICE(std::sin(y));
  y += TWICE(std::sin(y));
  SHOW(3.0);
  return y;
}

int main() { std::printf("%g\n", f(1.3)); }
