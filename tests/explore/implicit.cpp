// A solver marked implicit(...) on paths: the derivative takes the equation's way where a way leads through the solver.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=explore 2>&1 | FileCheck %s
// CHECK: kernel before_and_after:
// CHECK: explored 1 path, 0 selects between them; complete: no guards
// CHECK: the ways from 2 decisions came together
// CHECK: kernel on_one_way:
// CHECK: explored 2 paths, 1 select between them; complete: no guards
// RUN: %symreal verify %s before_and_after.c on_one_way.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: kernel before_and_after, mode finite: 1000 samples
// SAME: every path is recorded: no sample is left to a guard
// SAME: jacobian_value_return_M_e[0][1] 2 {{0[.][0-9]+|[0-9.]+e-[0-9]+}} 0 {{[1-9][0-9]+}} of 500
// SAME: kernel on_one_way, mode finite: 1000 samples
// SAME: every path is recorded: no sample is left to a guard
// SAME: jacobian_value_return_M_e[0][1] 2 {{0[.][0-9]+|[0-9.]+e-[0-9]+}} 0 {{[1-9][0-9]+}} of 500
#include <cmath>
#include <cstdio>
#include <utility>

#pragma symreal function input(M, e) output(return) jacobian(return, [M, e])
double before_and_after(double M, double e) {
  bool const is_negative = M < 0;
  double m = is_negative ? -M : M, E = m;
  for (int i = 0; i < 12; i++) E = E - (E - e * sin(E) - m) / (1 - e * cos(E));
  double const r = E - e * sin(E) - m;
#pragma symreal implicit(E, r)
  if (is_negative) E = -E;
  if (E > 1) {
    std::swap(E, m);
    E = 2 * m + E;
  }
  return E;
}

#pragma symreal function input(M, e) output(return) range(-3, 3) jacobian(return, [M, e])
double on_one_way(double M, double e) {
  double E = M * e;
  if (M < 0.5) {
    E = M;
    for (int i = 0; i < 12; i++) E = E - (E - 0.3 * sin(E + e) - M) / (1 - 0.3 * cos(E + e));
    double const r = E - 0.3 * sin(E + e) - M;
#pragma symreal implicit(E, r)
    E = 2 * E;
  }
  return E * E;
}

int main() { std::printf("%g %g\n", before_and_after(0.5, 0.3), on_one_way(0.4, 0.3)); }
