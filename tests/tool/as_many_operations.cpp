// --stats says where the generated code has no fewer operations than the original had.
// RUN: %symreal generate %s -o %t.c --kernel axpy --stats 2>&1 | FileCheck %s
// CHECK: the generated code has as many operations as the original (8 of 8): where a compiler makes vector code of the original's loops, the original may win; measure both
// RUN: %symreal generate %s -o %t.c --kernel zeros --stats 2>&1 | FileCheck %s --check-prefix=FEWER
// FEWER-NOT: as many operations
#include <cstdio>

#pragma symreal function input(a, x[0:4], y[0:4]) output(z[0:4])
void axpy(double a, double const *x, double const *y, double *z) {
  for (int i = 0; i < 4; ++i) z[i] = a * x[i] + y[i];
}
#pragma symreal function input(x[0:4]) output(z[0:4])
void zeros(double const *x, double *z) {
  for (int i = 0; i < 4; ++i) z[i] = 0.0 * x[i] + x[0];
}

int main() {
  double x[4] = {1, 2, 3, 4}, y[4] = {4, 3, 2, 1}, z[4];
  axpy(2, x, y, z);
  zeros(x, z);
  std::printf("%g\n", z[3]);
}
