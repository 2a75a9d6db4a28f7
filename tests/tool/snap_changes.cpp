// A constant that --snap would take for another, where that is seen in an output, is an error; nothing is written.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c --fp=fast --snap=1e-8 2>&1 | FileCheck %s
// RUN: not ls %t.c
// The ways out.
// RUN: %symreal generate %s -o %t.c --fp=fast --snap 2>&1 | FileCheck %s --check-prefix=NEARER
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c
// RUN: %symreal generate %s -o %t.c --fp=fast --snap=1e-8 --tol=1e-6
// RUN: not %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=VERIFIED
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c --tol=1e-6
#include <cmath>
#include <cstdio>

#pragma symreal function input(x) range(-10, 10) output(return)
double residue(double x) {
  double const nearly_one = std::cos(1.2345e-4), nothing = std::cos(std::acos(-1.0) / 2);
  // CHECK: snap_changes.cpp:[[@LINE+1]]:{{[0-9]+}}: error: value_return changes from {{.*}} by more than 1e-09 of the larger of its magnitude and 1 [SYM162]
  return x * nearly_one + std::sin(x) * nothing;
  // CHECK-DAG: note: 0.9999999923800488 counts as 1, in 1 place
  // CHECK-DAG: note: 6.123233995736766e-17 counts as 0, in 1 place
  // CHECK: help: give a smaller distance
  // NEARER: snap_changes.cpp:[[@LINE-4]]:{{[0-9]+}}: remark: 6.123233995736766e-17 counts as 0, in 1 place [SYM160]
  // NEARER-NOT: remark
  // VERIFIED: in extended precision the original is off by {{.*}}, the generated code by {{.*}}: more than 4 times as far
}

int main() { std::printf("%g\n", residue(3)); }
