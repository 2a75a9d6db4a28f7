// Sines and cosines of angles that a few sums and products make of inputs, beside those of inputs themselves: all side
// by side, before anything else. Angles that follow from other sines stay calls of the library.
// RUN: %symreal generate %s -o %t.c --fp=fast --effort=0 2>&1 | FileCheck %s --check-prefix=REMARK
// RUN: FileCheck %s < %t.c
// RUN: gcc -std=c99 -pedantic -Wall -Wextra -Wconversion -Werror -O2 -c %t.c -o %t.o
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c --seed 3
// RUN: %symreal generate %s -o %t.cpp --lang=cpp --fp=fast --effort=0
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.cpp --seed 3
// RUN: %symreal generate %s -o %t.v.c --fp=fast --effort=0 --vector=2
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.v.c --seed 3
// RUN: %symreal generate %s -o %t.r.c --fp=fast --effort=0 --reroll 2>&1 | FileCheck %s --check-prefix=LOOPS
// RUN: FileCheck %s --check-prefix=LOOP < %t.r.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.r.c --seed 3
#include <cmath>
#include <cstdio>

// REMARK: compute: sine and cosine of 1 input and 41 computed angles side by side

// CHECK: static void compute_angles(double const *input, double const *constants, double *restrict
// CHECK-NEXT: computed_angle) {
// CHECK-NEXT: (void)constants;
// CHECK: computed_angle[40] = t{{[0-9]+}};
// CHECK: void compute(double const *input, double const *constants, double *output) {
// CHECK-NOT: sin(input
// CHECK: double sine[42];
// CHECK-NEXT: double cosine[42];
// CHECK-NEXT: sines_and_cosines(1, input, sine, cosine);
// CHECK-NEXT: double computed_angle[41];
// CHECK-NEXT: compute_angles(input, constants, computed_angle);
// CHECK-NEXT: sines_and_cosines(41, computed_angle, sine + 1, cosine + 1);
// CHECK: sin({{.*}}sine[0]
// CHECK-NOT: sin(
// CHECK: output[2] = y_2;

// LOOPS: angles: 1 loop holds {{[0-9]+}} of {{[0-9]+}} operations; compute: 1 loop holds
// LOOP: static void compute_angles_{{[0-9]+}}(double const *input, double *restrict v) {
// LOOP: for (int k = 0; k < {{[34][0-9]}}; ++k) {
// LOOP: static void compute_angles(double const *input, double const *constants, double *computed_angle) {
// LOOP: sine[k + {{[0-9]+}}]
#pragma symreal function input(x[0 : 3]) range(-2, 2) output(y[0 : 3])
void kernel(double const *x, double *y) {
  double const offset = x[1] - x[2];
  double sum = 0;
  for (int k = 0; k < 40; ++k) sum += (0.25 + 0.125 * k) * std::sin((0.75 + 0.5 * k) * x[0] + 1.0 / (k + 2)) * x[1];
  y[0] = sum;
  y[1] = std::cos(offset) * std::sin(x[0]);
  y[2] = std::sin(std::sin(x[0]) * 3) + x[2];
}
int main() {
  double const x[3] = {0.5, 1.5, -0.25};
  double y[3];
  kernel(x, y);
  std::printf("%g\n", y[0] + y[1] + y[2]);
}
