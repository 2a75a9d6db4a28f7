// The order of what is sorted, and of keys in a set, rests on comparisons: each is a decision, with the place in the user's
// source, and under guards the order is that of the recording.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c --decisions=guard 2>&1 | FileCheck %s --check-prefix=GUARD
// RUN: %symreal verify --samples=100 %s %t.c --min-samples 1
#include <algorithm>
#include <cstdio>
#include <set>

#pragma symreal function input(x[0:3]) output(return)
double middle(double const *x) {
  double sorted[3] = {x[0], x[1], x[2]};
  std::sort(sorted, sorted + 3);
  std::set<double> const keys(x, x + 2);
  return sorted[1] + *keys.begin();
}

int main() {
  double const x[3] = {0.5, 0.25, 2.0};
  std::printf("%g\n", middle(x));
}

// CHECK-DAG: sorting.cpp:15:{{[0-9]+}}: error: the program decides on a symbolic value: x[1] < x[0]
// CHECK-DAG: sorting.cpp:16:{{[0-9]+}}: error: the program decides on a symbolic value: x[{{[01]}}] < x[{{[01]}}]
// GUARD: guard 1 {{.*}}sorting.cpp:15:
