// The functions and operators of std::complex compute what the C library and the compiler compute for double: to the last
// bit, in the recorded program, in its carried values and in generated code.
// RUN: %same %s
// RUN: %cxx -std=c++20 -ffp-contract=off -fno-builtin %s -o %t.orig && %symreal-c++ -std=c++20 %s -o %t.exe
// RUN: %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: %symreal generate %s -o %t.c 2>/dev/null && FileCheck %s --input-file=%t.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// RUN: %if all %{ %symreal generate %s -o %t.strict.c --fp=strict 2>/dev/null %}
// RUN: %if all %{ %symreal verify --samples=100 --min-samples=10 %s %t.strict.c 2>&1 | FileCheck %s --check-prefix=STRICT %}
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -c %t.c -o %t.o
// RUN: %if all %{ %clang -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -c %t.strict.c -o %t.o %}
#include <complex>
#include <cstdio>

using Complex = std::complex<double>;

// CHECK: double _Complex casin(double _Complex);
// CHECK-NOT: symreal_complex_multiply
// CHECK: symreal_complex_divide({{.*}}, input[2], input[3], &r
// SAME: {{9[0-9]+}} within the premises
// SAME: y[0][0] 58 0 0
// STRICT: y[0][0] 58 0 0
#pragma symreal function input(z, w) range(-3, 3) output(y[0:29])
void all(Complex z, Complex w, Complex *y) {
  y[0] = std::abs(z) + std::arg(z) + std::norm(z);
  y[1] = z * w;
  y[2] = z / w;
  y[3] = 2.5 / z;
  y[4] = z / 2.5;
  y[5] = std::conj(z) - w + 1.5;
  y[6] = std::proj(z);
  y[7] = std::polar(std::abs(z), std::arg(w));
  y[8] = std::sqrt(z);
  y[9] = std::exp(z);
  y[10] = std::log(z);
  y[11] = std::log10(z);
  y[12] = std::pow(z, w);
  y[13] = std::sin(z);
  y[14] = std::cos(z);
  y[15] = std::tan(z);
  y[16] = std::asin(z);
  y[17] = std::acos(z);
  y[18] = std::atan(z);
  y[19] = std::sinh(z);
  y[20] = std::cosh(z);
  y[21] = std::tanh(z);
  y[22] = std::asinh(z);
  y[23] = std::acosh(z);
  y[24] = std::atanh(z);
  y[25] = std::sqrt(Complex(z.real())) + std::exp(Complex(0, z.imag()));
  y[26] = std::fabs(z) * std::log<double>(w);
  y[27] = w;
  y[27] *= z;
  y[27] /= w + 1.0;
  y[28] = std::exp(z * 200.0);
}

int main() {
  Complex y[29];
  double const parts[] = {0.75, -1.5, 2.25, -0.3, 0.0, 1.0, -2.0};
  for (double a : parts)
    for (double b : parts)
      for (double c : parts) {
        all({a, b}, {c, 1.25}, y);
        for (Complex const &value : y) std::printf("%.17g %.17g\n", value.real(), value.imag());
      }
}
