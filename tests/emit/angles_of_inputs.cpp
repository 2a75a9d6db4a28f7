// Sines and cosines of inputs side by side: where they stand apart among the inputs, beside others that stay calls of
// the library, in an arm of a select, in an exact stretch, in vectors, and where all paths are explored.
// RUN: %symreal generate %s -o %t.c --fp=fast --effort=0 --decisions=select 2>&1 | FileCheck %s --check-prefix=REMARK
// RUN: FileCheck %s < %t.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c --seed 3
// RUN: %symreal generate %s -o %t.cpp --lang=cpp --fp=fast --effort=0 --decisions=select
// RUN: FileCheck %s --check-prefix=CPP < %t.cpp
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.cpp --seed 3
// RUN: %symreal generate %s -o %t.v.c --fp=fast --effort=0 --decisions=select --vector=2
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.v.c --seed 3
// RUN: %symreal generate %s -o %t.e.c --fp=fast --effort=0 --decisions=explore
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.e.c --seed 3
#include <cmath>
#include <cstdio>

// REMARK: compute: sine and cosine of 3 inputs side by side

// CHECK: double const angle[3] = {
// CHECK-NEXT: input[0], input[2], input[4]};
// CHECK: sines_and_cosines(3, angle, sine, cosine);
// CHECK-DAG: sin(input[0]*2.0)
// CHECK-DAG: if (t{{[0-9]+}}) {
// CHECK-DAG: sin(input[1])
// CHECK-DAG: cos(input[3])
// CHECK-DAG: sine[1]*sine[0]
// CHECK: output[1] = cosine[2];
// CPP: static void sines_and_cosines(int count, double const *angle, double *__restrict sine,
// CPP: std::sin(angle[k])
#pragma symreal function input(x[0 : 5]) range(-3, 3) output(y[0 : 6])
void kernel(double const *x, double *y) {
  y[0] = std::sin(x[0]) * std::sin(x[2]) + x[1];
  y[1] = std::cos(x[4]);
  y[2] = std::sin(x[0] * 2) * x[3];
  y[3] = x[1] > 0.5 ? std::sin(x[1]) * (std::sin(x[1]) * x[2] + x[3]) : x[2];
  y[4] = 0;
#pragma symreal exact
  y[4] = std::cos(x[3]) + x[0];
  y[5] = std::cos(x[0]) - std::sin(x[4]) * std::cos(x[2]);
}
int main() {
  double const x[5] = {0.5, 1.5, 2.5, 0.75, -1};
  double y[6];
  kernel(x, y);
  std::printf("%g %g\n", y[0], y[5]);
}
