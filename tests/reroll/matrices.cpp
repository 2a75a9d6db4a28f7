// Loops over the rows and columns of matrices are two loops, one in the other, without tables of indices.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s --reroll -o %t 2>&1 | FileCheck %s --check-prefix=SAID
// SAID: compute: 2 loops hold 16128 of 16128 operations
// RUN: FileCheck %s --input-file=%t/covariance.c
// CHECK: for (int i = 0; i < 16; ++i) {
// CHECK-NEXT: double const [[ROW:f[0-9]+]] = input[16*i];
// CHECK: for (int j = 0; j < 16; ++j) {
// CHECK-NEXT: [[ROW]]*input[j + 256]
// CHECK: v[16*i + j] = {{[a-z0-9]+}};
// CHECK: for (int i = 0; i < 16; ++i) {
// CHECK: for (int j = 0; j < 16; ++j) {
// CHECK: input[16*i + j + 512] + input[16*j]*
// CHECK-NOT: table

// RUN: FileCheck %s --check-prefix=TRIANGLES --input-file=%t/triangles.c
// TRIANGLES: int k = 0;
// TRIANGLES: for (int j = 0; j < i + 1; ++j) {
// TRIANGLES: v[k] = {{.*}};
// TRIANGLES-NEXT: ++k;
// TRIANGLES: for (int j = 0; j < 20 - i; ++j) {
// TRIANGLES: output[20*i + j] = {{.*}};
// TRIANGLES: output[21*i + j + 400] = {{.*}};

// RUN: FileCheck %s --check-prefix=BACKWARDS --input-file=%t/backwards.c
// BACKWARDS: for (int j = 0; j < 20; ++j) {
// BACKWARDS: input[{{[0-9]+}} - 20*i - j]
// RUN: %symreal verify %s %t/covariance.c %t/triangles.c %t/backwards.c --samples=100 2>&1 \
// RUN:   | FileCheck %s --check-prefix=SAME
// SAME-COUNT-3: mode finite: 100 samples, 100 within the premises
// SAME-NOT: error
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -Wshadow -pedantic -Werror -O1 -c %t/covariance.c -o %t/covariance.o
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -Wshadow -pedantic -Werror -O1 -c %t/triangles.c -o %t/triangles.o
// RUN: %clang -std=c99 -Wall -Wextra -Wconversion -Wshadow -pedantic -Werror -O1 -c %t/triangles.c -o %t/triangles.o
#include <cmath>

constexpr int n = 16, rows = 20;

#pragma symreal function input(F[0 : n][0 : n], P[0 : n][0 : n], Q[0 : n][0 : n]) output(R[0 : n][0 : n])
void covariance(double const F[n][n], double const P[n][n], double const Q[n][n], double R[n][n]) {
  double T[n][n];
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      T[i][j] = 0;
      for (int k = 0; k < n; ++k) T[i][j] += F[i][k] * P[k][j];
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      R[i][j] = Q[i][j];
      for (int k = 0; k < n; ++k) R[i][j] += T[i][k] * F[j][k];
    }
}

#pragma symreal function input(x[0 : rows], y[0 : rows]) range(0.5, 2)                                                 \
    output(L[0 : rows][0 : rows], U[0 : rows][0 : rows])
void triangles(double const x[rows], double const y[rows], double L[rows][rows], double U[rows][rows]) {
  for (int k = 0; k < rows * rows; ++k) L[0][k] = U[0][k] = 0;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j <= i; ++j) L[i][j] = std::sqrt(1 + (x[i] - y[j]) * (x[i] - y[j])) / (2 + std::exp(x[i] - y[j]));
  for (int i = 0; i < rows; ++i)
    for (int j = i; j < rows; ++j) U[i][j] = std::exp((x[i] + y[j]) * (x[i] + y[j])) / (2 + std::sqrt(x[i] + y[j]));
}

#pragma symreal function input(A[0 : rows][0 : rows], x[0 : rows]) output(B[0 : rows][0 : rows])
void backwards(double const A[rows][rows], double const x[rows], double B[rows][rows]) {
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j) {
      double const a = A[rows - 1 - i][rows - 1 - j];
      B[i][j] = (a + x[i]) * (a - x[j]) + a * a * x[i];
    }
}

int main() {
  double F[n][n], P[n][n], Q[n][n], R[n][n], x[rows], y[rows], L[rows][rows], U[rows][rows], A[rows][rows];
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) F[i][j] = i == j ? 1 : 0.01 * (i - j), P[i][j] = Q[i][j] = 1.0 / (i + j + 1);
  for (int i = 0; i < rows; ++i) {
    x[i] = 1 + 0.02 * i, y[i] = 1 - 0.01 * i;
    for (int j = 0; j < rows; ++j) A[i][j] = 0.1 * i - 0.2 * j;
  }
  covariance(F, P, Q, R);
  triangles(x, y, L, U);
  double B[rows][rows];
  backwards(A, x, B);
  return R[0][0] == 0;
}
