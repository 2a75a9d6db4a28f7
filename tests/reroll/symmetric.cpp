// Loops store results themselves once all inputs are read, and of a symmetric matrix one half is copied from the other.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s --reroll -o %t/matrix.c 2>&1 | FileCheck %s --check-prefix=SAID
// SAID: compute: {{[0-9]+}} loops hold
// RUN: FileCheck %s --input-file=%t/matrix.c
// CHECK: static void compute_{{[0-9]+}}(double const *v, double *restrict output) {
// CHECK: for (int k = 0; k < 20; ++k) {
// CHECK: output[k + 400] = {{[a-z0-9_]+}};
// CHECK-NEXT: }
// CHECK: void compute(
// CHECK: /* A symmetric matrix: one half is the other. */
// CHECK-NEXT: for (int first = 0; first < 20; first += 8) {
// CHECK-NEXT: int const end = first + 8 < 20 ? first + 8 : 20;
// CHECK: for (int column = first; column < row; ++column) output[20*row + column] = output[20*column + row];
// CHECK: for (int column = first; column < first + 8; ++column) output[20*row + column] = output[20*column + row];
// RUN: %symreal verify %s %t/matrix.c --samples=100 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: mode finite: 100 samples, 100 within the premises
// SAME-NOT: error
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -Wshadow -pedantic -Werror -O2 -c %t/matrix.c -o %t/matrix.o
// RUN: %cxx -DOVERLAP %s %t/matrix.o -lm -o %t/overlap && %t/overlap
#include <cmath>

constexpr int rows = 20;

#ifndef OVERLAP
// P is symmetric; what y is made of has read all of x before.
#pragma symreal function input(x[0 : rows]) output(P[0 : rows][0 : rows], y[0 : rows])
void kernel(double const x[rows], double P[rows][rows], double y[rows]) {
  double z[rows], sum = 0;
  for (int k = 0; k < rows; ++k) sum = 0.5 * sum + x[k];
  for (int k = 0; k < rows; ++k) z[k] = x[k] + sum;
  for (int k = 0; k < rows; ++k) y[k] = std::sqrt(1 + z[k] * z[k]) + z[k] * (z[k] + 3) * (z[k] - 2);
  for (int i = 0; i < rows; ++i)
    for (int j = i; j < rows; ++j) P[i][j] = P[j][i] = (z[i] + 2 * z[j]) * (z[i] - z[j]) + z[i] * z[j];
}

int main() {
  double x[rows], P[rows][rows], y[rows];
  for (int k = 0; k < rows; ++k) x[k] = 0.1 * k;
  kernel(x, P, y);
  return P[1][0] != P[0][1] || y[0] == 0;
}
#else
// The arrays may overlap.
extern "C" void compute(double const *input, double const *constants, double *output);

int main() {
  double input[rows], apart[rows * (rows + 1)], shared[rows * (rows + 1)];
  for (int k = 0; k < rows; ++k) input[k] = shared[k] = std::cos(k);
  compute(input, nullptr, apart);
  compute(shared, nullptr, shared);
  for (int k = 0; k < rows * (rows + 1); ++k)
    if (apart[k] != shared[k]) return 1;
  return 0;
}
#endif
