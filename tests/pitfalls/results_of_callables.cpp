// A std::function converts what its callable returns.
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
#include <cstdio>
#include <functional>

static double twice(double x) { return 2 * x; }

int main() {
  double x = 2.75, y;
#pragma symreal input(x) range(1, 3)
  // CHECK: f = REAL_ONLY(::symreal::SymrealReturning<int>() ->*) [](REAL q) { return q; };
  std::function<int(double)> f = [](double q) { return q; };
  // CHECK: g = REAL_ONLY(::symreal::SymrealReturning<float>() ->*) twice;
  std::function<float(double)> const g = twice;
  // CHECK: h = [](REAL q) { return 3 * q; };
  std::function<double(double)> const h = [](double q) { return 3 * q; };
  y = f(1.75) + g(0.25) + h(x);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
