// Eigen's decompositions decide on pivots, in code that knows nothing of it. Complete but for exact zeros; verification has
// zeros among its samples, and the code refuses no others.
// REQUIRES: all
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=explore --max-paths=400 -- -I/usr/include/eigen3 2> %t/table
// RUN: FileCheck %s < %t/table
// CHECK-NOT: warning
// CHECK: kernel ldlt:
// CHECK: explored 364 paths, 18 selects between them; complete but for exact zeros: see the guards
// CHECK: kernel partial_piv_lu:
// CHECK: explored 8 paths, {{[0-9]+}} selects between them; complete but for exact zeros: see the guards
// RUN: %symreal verify %s ldlt.c partial_piv_lu.c -- -I/usr/include/eigen3 > %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SAME < %t/verified
// SAME: kernel ldlt, mode finite: 1000 samples and {{[0-9]+}} around decisions, 9{{[0-9]+}} within the premises
// SAME: x[0] 3 0 0{{$}}
// SAME: kernel partial_piv_lu, mode finite: 1000 samples and {{[0-9]+}} around decisions, {{1[0-9]+|9[0-9]+}} within the premises
// SAME: x[0] 3 0 0{{$}}
#include <Eigen/Dense>
#include <cstdio>

#pragma symreal function input(a[0:9], b[0:3]) output(x[0:3])
void ldlt(double const *a, double const *b, double *x) {
  Eigen::Map<Eigen::Matrix3d const> const A(a);
  Eigen::Map<Eigen::Vector3d>(x, 3) = A.ldlt().solve(Eigen::Map<Eigen::Vector3d const>(b));
}

#pragma symreal function input(a[0:9], b[0:3]) output(x[0:3])
void partial_piv_lu(double const *a, double const *b, double *x) {
  Eigen::Map<Eigen::Matrix3d const> const A(a);
  Eigen::Map<Eigen::Vector3d>(x, 3) = A.partialPivLu().solve(Eigen::Map<Eigen::Vector3d const>(b));
}

int main() {
  double a[9] = {4, 1, 2, 1, 5, 3, 2, 3, 6}, b[3] = {1, 2, 3}, x[3], y[3];
  ldlt(a, b, x);
  partial_piv_lu(a, b, y);
  std::printf("%g %g\n", x[0], y[0]);
}
