// Functions of the library that decide on their arguments or compute in the type that several arguments have in common:
// for REAL as for double, to the last bit, without a decision.
// RUN: %same %s -- -std=c++20
// RUN: %cxx -std=c++20 -ffp-contract=off -fno-builtin %s -o %t.orig && %symreal-c++ -std=c++20 %s -o %t.exe
// RUN: %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: %symreal generate %s -o %t.c -- -std=c++20 2>/dev/null && FileCheck %s --input-file=%t.c
// RUN: %symreal verify %s %t.c --samples=100 -- -std=c++20 2>&1 | FileCheck %s --check-prefix=SAME
// CHECK: void compute
// SAME: 100 samples and 44 around decisions, 144 within the premises
// SAME: y[0] 17 0 0
#include <cmath>
#include <cstdio>
#include <numeric>
#include <valarray>
#include <vector>
#pragma symreal function input(x[0:3]) range(0.1, 0.9) output(y[0:17])
void lib(double const *x, double *y) {
  y[0] = std::hypot(x[0], x[1], x[2]);
  y[1] = std::hypot(x[0], 2.0, x[2]) + std::hypot(1, x[1], 2.5f);
  y[2] = std::midpoint(x[0], x[1]);
  y[3] = std::midpoint(x[0], 1.5);
  y[4] = std::accumulate(x, x + 3, 0.0);
  y[5] = std::inner_product(x, x + 3, x, 1.0);
  y[6] = std::reduce(x, x + 3);
  y[7] = std::transform_reduce(x, x + 3, x, 0.5);
  std::valarray<double> v(x, 3);
  std::valarray<double> w = std::sqrt(v) + 2.0 * v * v + std::pow(v, 2.5);
  y[8] = w.sum() + w[1];
  y[9] = std::pow(x[0], 3) + std::pow(x[1], 2.0) + std::pow(2, x[1]) + std::pow(1.5f, x[0]);
  y[10] = std::fma(x[0], 2.0, x[1]) + std::fma(3, x[1], x[2]);
  std::vector<double> p(3);
  std::partial_sum(x, x + 3, p.begin());
  y[11] = p[2];
  std::inclusive_scan(x, x + 3, p.begin());
  y[12] = p[2];
  y[13] = std::fma(2.0, x[0], 1) + std::fma(x[1], x[2], 3) + std::atan2(x[0], 2) + std::fmod(x[0], 0.3f) + std::fmax(x[1], 1);
  y[14] = std::lerp(x[0], x[1], x[2]) + std::lerp(1.0, x[1], 0.5);
  y[15] = std::transform_reduce(x, x + 3, 0.0, std::plus<>(), [](double q) { return q * q; });
  y[16] = std::midpoint(x[0] * 1e308, x[1] * 1.7e308);
}
int main() { double x[3] = {0.3, 0.7, 0.55}, y[17]; lib(x, y); for (double v : y) std::printf("%.17g\n", v); }
