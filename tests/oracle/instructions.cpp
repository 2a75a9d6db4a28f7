// Each kind of instruction that clang makes of operations on doubles: both recordings give the same numbers.
// RUN: %symreal oracle %s --samples=300 2>&1 | FileCheck %s
// RUN: %symreal oracle %s --samples=300 --fp=strict --json | FileCheck %s --check-prefix=JSON
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstring>

// CHECK: kernel arithmetic: 8 operations recorded, 7 by the oracle
// CHECK-NEXT: 300 samples within the premises and the guards of both, 0 outside
// JSON: "different": 0
#pragma symreal function input(x, y) output(return)
double arithmetic(double x, double y) {
  double const z = (x + y) * (x - y) / 3.0;
  return -z + std::fmod(z, 2.5) - 1.0;
}

// CHECK: kernel functions: 15 operations recorded, 15 by the oracle
// CHECK-NEXT: 300 samples
#pragma symreal function input(x) range(0.1, 0.9) input(y) range(0.1, 0.9) output(return)
double functions(double x, double y) {
  return std::sin(x) + std::pow(x, y) + std::abs(y) + std::atan2(y, x) + std::fmin(x, y) + __builtin_sqrt(x) +
         std::copysign(x, y) + std::fma(x, y, 1.0);
}

// CHECK: kernel several: {{[0-9]+}} operations recorded
// CHECK-NEXT: 300 samples
#pragma symreal function input(x) range(0.1, 5) output(return)
double several(double x) {
  double whole;
  double const part = std::modf(3 * x, &whole);
  return std::ldexp(part, 3) + whole + std::norm(std::complex<double>(x, 2) * std::complex<double>(1, x));
}

// Comparisons that stay conditions for the oracle.
// CHECK: kernel selects: {{[0-9]+}} operations recorded
// CHECK-NEXT: {{[1-9][0-9]+}} samples
#pragma symreal function input(x, y) output(return)
double selects(double x, double y) {
  double const largest = x < y ? y : x, clamped = std::min(std::max(x, -1.0), 1.0);
  bool const inside = x > -2.0 && !(y >= 2.0);
  return largest + clamped + (inside ? 1.0 : x) + (x == y ? 0.5 : y) + (std::isnan(x) ? 0.0 : 1.0);
}

// A decision, a conversion, text and the other instructions that nodes must not reach.
// CHECK: kernel decisions: {{[0-9]+}} operations recorded
// CHECK-NEXT: {{[1-9][0-9]+}} samples
#pragma symreal function input(x) range(1, 2) input(y) range(3, 4) output(results[0:2])
void decisions(double x, double y, double results[2]) {
  if (x < y) results[0] = x * y;
  else results[0] = x / y;
  char text[40];
  std::snprintf(text, sizeof text, "%s", "nothing symbolic");
  results[1] = std::sqrt(y) + static_cast<double>(std::strlen(text));
}

// CHECK: kernel vectors: 5 operations recorded, 5 by the oracle
// CHECK-NEXT: 300 samples
#pragma symreal function input(x[0:2], y) output(return)
double vectors(double const x[2], double y) {
  double const sum[2] = {x[0] * y + x[1], x[1] * y + x[0]};
  double copy[2];
  std::memcpy(copy, sum, sizeof copy);
  return copy[0] * copy[1];
}

int main() {
  double x[2] = {0.3, 0.7}, results[2];
  decisions(1.5, 3.5, results);
  return arithmetic(0.3, 0.7) + functions(0.3, 0.7) + several(0.4) + selects(0.3, 0.7) + vectors(x, 2.0) == 0;
}
