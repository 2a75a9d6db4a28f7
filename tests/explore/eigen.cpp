// Eigen's decompositions decide on pivots, in code that knows nothing of it: whole functions, complete but for exact zeros.
// Verification has zeros among its samples, and the code refuses no others. Where a rank is 0 Eigen sets the solution to 0,
// the very number that the caller may hold there.
// REQUIRES: all
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=explore -- -I/usr/include/eigen3 2> %t/table
// RUN: FileCheck %s < %t/table
// CHECK-NOT: warning
// CHECK: kernel ldlt:
// CHECK: explored 1 path, 0 selects between them; complete but for exact zeros: see the guards
// CHECK: tests for exact zero taken as not met
// CHECK: kernel partial_piv_lu:
// CHECK: explored 1 path, 0 selects between them; complete but for exact zeros: see the guards
// CHECK: kernel col_piv_qr:
// CHECK: explored 1 path, 0 selects between them; complete but for exact zeros: see the guards
// CHECK-NEXT: the ways from 1 decision came together: {{[0-9]+}} pieces of a run
// RUN: %symreal verify %s ldlt.c partial_piv_lu.c col_piv_qr.c -- -I/usr/include/eigen3 > %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SAME < %t/verified
// SAME: kernel ldlt, mode finite: 1000 samples and {{[0-9]+}} around decisions, {{9[0-9][0-9]|1[0-9]+}} within the premises
// SAME: x[0] 3 0 0{{$}}
// SAME: kernel partial_piv_lu, mode finite: 1000 samples and {{[0-9]+}} around decisions, {{9[0-9][0-9]|1[0-9]+}} within the premises
// SAME: x[0] 3 0 0{{$}}
// SAME: kernel col_piv_qr, mode finite: 1000 samples and {{[0-9]+}} around decisions, {{9[0-9][0-9]|1[0-9]+}} within the premises
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

#pragma symreal function input(a[0:9], b[0:3]) output(x[0:3])
void col_piv_qr(double const *a, double const *b, double *x) {
  Eigen::Map<Eigen::Matrix3d const> const A(a);
  Eigen::Map<Eigen::Vector3d>(x, 3) = A.colPivHouseholderQr().solve(Eigen::Map<Eigen::Vector3d const>(b));
}

int main() {
  double a[9] = {4, 1, 2, 1, 5, 3, 2, 3, 6}, b[3] = {1, 2, 3}, x[3];
  for (auto solve : {ldlt, partial_piv_lu, col_piv_qr}) {
    solve(a, b, x);
    std::printf("%g\n", x[0]);
  }
}
