// What is more than an array: containers, matrices, complex numbers, in a wrapper and where `verify` tries it.
// RUN: rm -rf %t && mkdir %t && cd %t && %symreal generate %s -o out.c --wrapper -- -I/usr/include/eigen3
// RUN: %if all %{ cd %t && %symreal verify %s out.c --samples 100 --min-samples 10 -- -I/usr/include/eigen3 2>&1 | FileCheck %s %}
// CHECK: the wrapper was tried as well
// RUN: cd %t && %cc -c out.c && %cxx -Wall -Wextra -Werror -std=c++14 -isystem /usr/include/eigen3 -c out_wrapper.cpp
// RUN: cd %t && %cxx -Wno-unknown-pragmas -I/usr/include/eigen3 %s -o original && ./original > expected
// RUN: cd %t && %cxx -DMAIN -I/usr/include/eigen3 %s out.o out_wrapper.o -o swapped && ./swapped | diff - expected
// Of another size.
// RUN: not --crash %t/swapped 2 2>&1 | FileCheck %s --check-prefix=SIZE
// SIZE: x: this call has other extents than the generated code
#include <Eigen/Dense>
#include <array>
#include <complex>
#include <cstdio>
#include <vector>

#ifndef MAIN
#pragma symreal function input(x, m, z, rows[0:2]) output(x, m, z, return)
double mix(std::vector<double> &x, Eigen::Matrix2d &m, std::complex<double> &z, std::array<double, 2> const *rows) {
  x[1] += x[0] * m(0, 1);
  m = m * m;
  z *= 2;
  return rows[1][0] - rows[0][1] + z.imag();
}
#else
double mix(std::vector<double> &x, Eigen::Matrix2d &m, std::complex<double> &z, std::array<double, 2> const *rows);
#endif

int main(int argc, char **) {
  std::vector<double> x(2 + argc, 1.5);
  Eigen::Matrix2d m;
  m << 1, 2, 3, 4;
  std::complex<double> z(0.5, 0.25);
  std::array<double, 2> const rows[2] = {{5, 6}, {7, 8}};
  double const result = mix(x, m, z, rows);
  std::printf("%g %g %g %g %g %g\n", result, x[1], m(0, 1), m(1, 1), z.real(), z.imag());
}
