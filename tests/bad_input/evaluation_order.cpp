// Where the order of operands cannot be kept: in one text for several types, in a macro's, and where gcc moves a sign,
// drops a factor or joins two choices, and begins with another operand than without them; and where an operand that is
// evaluated late would see another function's name.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <complex>
#include <cstdio>

static double state = 1.0;
static double next() { return state = state * 3.0 + 1.0; }
static std::complex<double> turn() { return {next(), 0.0}; }
// CHECK-DAG: evaluation_order.cpp:[[@LINE+1]]:{{[0-9]+}}: error: one operand changes what the other reads, or both change the same object [SYM133]
template <class T> T difference(T (*make)()) { return make() - next(); }
#define SQUARE(x) ((x) * (x))

int main() {
  double x = 1.0, y;
#pragma symreal input(x)
  // CHECK-DAG: evaluation_order.cpp:[[@LINE+1]]:{{[0-9]+}}: error: one operand changes what the other reads, or both change the same object [SYM133]
  y = x * SQUARE(next());
  y += difference<double>(next) + std::real(difference<std::complex<double>>(turn));
  int const choice = x > 3.0;
  // CHECK-DAG: evaluation_order.cpp:[[@LINE+1]]:20: error: one operand changes what the other reads, or both change the same object [SYM133]
  y += state * 7.0 + -next();
  // CHECK-DAG: evaluation_order.cpp:[[@LINE+1]]:22: error: one operand changes what the other reads, or both change the same object [SYM133]
  y += (state * 1.0) * (next() + x);
  // CHECK-DAG: evaluation_order.cpp:[[@LINE+1]]:35: error: one operand changes what the other reads, or both change the same object [SYM133]
  y += (choice ? next() : next()) - next() * 2.0;
  // CHECK-DAG: evaluation_order.cpp:[[@LINE+1]]:21: error: one operand is evaluated late, and asks for the name of its function [SYM133]
  y += next() * 2.0 * (next() + sizeof __func__ + __func__[0]);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
