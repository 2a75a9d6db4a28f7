// std::complex of REAL computes as the library's complex of double does.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify --samples=100 %s %t.c --min-samples 50
// RUN: FileCheck %s --input-file=%t.c
#include <complex>
#include <cstdio>

// CHECK: input[0]
#pragma symreal function input(z, w) range(0.5, 2) output(return, y)
double magnitude(std::complex<double> z, std::complex<double> w, std::complex<double> &y) {
  y = z * w + std::conj(z) - 2.0 * w;
  return std::norm(z) + y.real();
}

int main() {
  std::complex<double> y;
  std::printf("%g\n", magnitude({0.75, 1.5}, {1.25, 0.625}, y));
}
