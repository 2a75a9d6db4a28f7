// The functions of <math.h>: those with more than one result, with an integer as result, with a truth value.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify --samples=100 %s %t.c --min-samples 1
// RUN: not %symreal generate %s -o %t_error.c 2>&1 | FileCheck %s
#include <cmath>
#include <cstdio>

#pragma symreal function input(x, y) range(0.5, 2) output(return)
double many(double x, double y) {
  double whole, sine, cosine;
  double sum = std::modf(x, &whole) + std::sqrt(y) + std::fabs(x) + std::ldexp(x, 3) + std::hypot(x, y);
  sincos(y, &sine, &cosine);
  sum += whole + sine * cosine + std::fma(x, y, 1.0) + std::cbrt(x) + std::log1p(y) + std::erf(x) + std::fmod(x, y);
  sum += static_cast<double>(std::lround(x)) + std::nextafter(x, y) + std::logb(y) + std::hypot(x, y, 1.5);
  int quotient;
  sum += std::remquo(9 * x, y, &quotient);
  sum += quotient;
  // CHECK-DAG: library_functions.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: {{.*}}y
  if (std::signbit(y)) sum += 1.0;
  if (std::isfinite(x) && !std::isnan(y)) sum += 2.0;
  return sum;
}

int main() { std::printf("%g\n", many(0.75, 1.25)); }
