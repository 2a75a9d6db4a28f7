// Truth values as numbers keep their dependency: a select, or a decision at its place.
// RUN: rm -f %t.c
// RUN: %symreal generate %s -o %t.c --decisions=select && %symreal verify --samples=100 --min-samples=10 %s %t.c
// RUN: FileCheck %s --input-file=%t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s --check-prefix=ERROR
#include <cmath>
#include <cstdio>

// CHECK: (input[1] > 0.0 ? 1.0 : 0.0)
// CHECK: (input[0] > 0.0 ? 1.0 : 0.0)
#pragma symreal function input(x, y) output(return)
double sign(double x, double y) {
  double const direction = (x > 0) - (x < 0);
  return direction * std::sin(x) + x * (y > 0);
}

int main() { std::printf("%g\n", sign(0.5, 2.0)); }

// ERROR-DAG: truth_as_number.cpp:13:{{[0-9]+}}: error: the program decides on a symbolic value: x > 0
// ERROR-DAG: truth_as_number.cpp:13:{{[0-9]+}}: error: the program decides on a symbolic value: x < 0
// ERROR-DAG: truth_as_number.cpp:14:{{[0-9]+}}: error: the program decides on a symbolic value: y > 0
