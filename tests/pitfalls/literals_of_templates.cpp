// A template that returns a literal as what it is instantiated for: a number, or a class of numbers.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <complex>
#include <cstdio>

template <class T> struct Unweighted {
  // CHECK: T weight(T const &) { return REAL_FIT(1.5); }
  T weight(T const &) { return 1.5; }
};

int main() {
  double x = 0.5, y;
#pragma symreal input(x)
  std::complex<double> const z(x, 1.0);
  y = x * Unweighted<double>().weight(x) + (z * Unweighted<std::complex<double>>().weight(z)).real();
  y += static_cast<double>(Unweighted<float>().weight(2.0f));
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
