// Which pow of a complex number is meant, multiplied out or through the logarithm, is what it is for double, whatever the
// exponent is: a literal, a constant, a number, an integer of any type, a float.
// RUN: %same %s
// RUN: %cxx -std=c++20 -ffp-contract=off -fno-builtin %s -o %t.orig && %symreal-c++ -std=c++20 %s -o %t.exe
// RUN: %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: %symreal generate %s -o %t.c 2>/dev/null && FileCheck %s --input-file=%t.c
// RUN: %symreal verify %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
#include <complex>
#include <cstdio>

using Complex = std::complex<double>;
constexpr double third = 1.0 / 3.0;
constexpr float half = 0.5f;

template <class T> std::complex<T> power(std::complex<T> const &z, T exponent) { return std::pow(z, exponent); }

// CHECK: *0.3333333333333333
// SAME: {{9[0-9]+}} within the premises
// SAME: y[0][0] 36 0 0
#pragma symreal function input(z, x) range(-3, 3) output(y[0:18])
void powers(Complex z, double x, Complex *y) {
  y[0] = std::pow(z, 1.0 / 3.0);
  y[1] = std::pow(z, 1.5f);
  y[2] = std::pow(z, third);
  y[3] = std::pow(z, half);
  y[4] = std::pow(z, x);
  y[5] = std::pow(z, 3);
  y[6] = std::pow(z, -2);
  y[7] = std::pow(z, 3L);
  y[8] = std::pow(z, 2u);
  y[9] = std::pow(z, 2.0);
  y[10] = std::pow(z, static_cast<short>(3));
  y[11] = std::pow(2.0, z);
  y[12] = std::pow(x, z);
  y[13] = std::pow(2, z) + std::pow(0.5f, z);
  y[14] = std::pow(z, Complex(0.5, 0.0));
  y[15] = power(z, 2.5) + power<double>(z, third);
  y[16] = std::pow<double>(z, 2.5);
  y[17] = std::pow(Complex(x), 0.5) + std::pow(z, std::complex<float>(1.5f));
}

int main() {
  Complex y[18];
  double const parts[] = {0.75, -1.5, 2.25, 1.0, -2.0};
  for (double a : parts)
    for (double b : {0.75, -1.5, 0.0})
      for (double c : parts) {
        powers({a, b}, c, y);
        for (Complex const &value : y) std::printf("%.17g %.17g\n", value.real(), value.imag());
      }
}
