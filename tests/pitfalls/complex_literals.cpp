// 2.0i is of the library's class of doubles, and goes with a complex number of REALs.
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
// RUN: %rewrite %s | FileCheck %s --check-prefix=TEXT
// RUN: %same %s
// CHECK: y[0] {{ *}}4 {{ *}}0 {{ *}}0
#include <complex>
#include <cstdio>
using namespace std::complex_literals;

int main() {
  double x = 0.5, y[4];
#pragma symreal input(x)
  // TEXT: std::complex<REAL> const z(x, 2.0), a = z * REAL_TO(::std::complex<REAL>, 1.0i), b = REAL_C(1.0) + REAL_TO(::std::complex<REAL>, 2.0i);
  std::complex<double> const z(x, 2.0), a = z * 1.0i, b = 1.0 + 2.0i;
  std::complex<double> c = 2.0i * z;
  c += x * 3.0i;
  auto const d = 1.0 - 2.0i;
  y[0] = a.real() + b.imag();
  y[1] = (c * b).real();
  y[2] = c.imag() + d.imag();
  y[3] = (z / d).real();
#pragma symreal output(y) generate("y.c")
  std::printf("%g %g %g %g\n", y[0], y[1], y[2], y[3]);
}
