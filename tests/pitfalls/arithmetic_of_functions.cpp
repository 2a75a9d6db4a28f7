// Pragmas of clang that contract, regroup or vectorise sums, in members, templates and lambdas.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c --cxx=clang++-19 2>&1 | FileCheck %s --implicit-check-not="SYM205"
// RUN: %symreal verify %s %t.c --cxx=clang++-19 --samples=200
// RUN: %rewrite %s | FileCheck %s --check-prefix=TEXT
#include <cstdio>

struct Model {
  double scale = 3;
  [[gnu::target("fma")]] double contracted(double a, double b) const {
    // CHECK-DAG: arithmetic_of_functions.cpp:[[@LINE+1]]:{{[0-9]+}}: warning: #pragma clang fp contract(fast) reassociate(on) is left out, of the reference as well: it changes arithmetic [SYM205]
#pragma clang fp contract(fast) reassociate(on)
    return a * b + scale;
  }
};
template <class T> [[gnu::target("fma")]] T fused(T a, T b) {
  // CHECK-DAG: arithmetic_of_functions.cpp:[[@LINE+1]]:{{[0-9]+}}: warning: #pragma STDC FP_CONTRACT ON is left out, of the reference as well: it changes arithmetic [SYM205]
#pragma STDC FP_CONTRACT ON
  return a * b + b;
}
// TEXT: REAL_EITHER((_Pragma("float_control(precise, off, push)")), _Pragma("float_control(push)"))
// CHECK-DAG: arithmetic_of_functions.cpp:[[@LINE+1]]:{{[0-9]+}}: warning: #pragma float_control(precise, off, push) is left out, of the reference as well: it changes arithmetic [SYM205]
#pragma float_control(precise, off, push)
static double regrouped(double a, double b) { return (a + b) - a; }
#pragma float_control(pop)
static double sum(double const *values, int count) {
  double total = 0;
  // CHECK-DAG: arithmetic_of_functions.cpp:[[@LINE+1]]:{{[0-9]+}}: warning: #pragma clang loop vectorize(enable) is left out, of the reference as well: it changes arithmetic [SYM205]
#pragma clang loop vectorize(enable)
  for (int i = 0; i < count; ++i) total += values[i];
  return total;
}

#pragma symreal function input(x, y) output(return)
double kernel(double x, double y) {
  auto const halved = [](double a, double b) {
    // CHECK-DAG: arithmetic_of_functions.cpp:[[@LINE+1]]:{{[0-9]+}}: warning: #pragma clang fp reassociate(on) is left out, of the reference as well: it changes arithmetic [SYM205]
#pragma clang fp reassociate(on)
    return (a + b) - b;
  };
  double const values[9] = {x, y, x * y, x + y, x - y, y / 3, x / 3, 1e9, x};
#pragma clang loop unroll(disable)
  for (int i = 0; i < 2; ++i) x += y;
  return Model().contracted(x, y) + fused(x, y) + regrouped(x, y) + sum(values, 9) + halved(x, y);
}

int main() { std::printf("%g\n", kernel(0.1, 1e9)); }
