// A wrapper compares the extents of a matrix, not the count of its numbers alone, and whether two matrices lie in one
// place. It makes the matrix that a function returns.
// RUN: rm -rf %t && mkdir %t && cd %t
// DEFINE: %{flags} = -std=c++17 -I/usr/include/eigen3
// DEFINE: %{c} = %cxx %{flags} -Wall -Wextra -Wno-unknown-pragmas
// RUN: cd %t && %symreal generate %s -o ./ --wrapper -- %{flags}
// RUN: cd %t && %symreal verify %s changed.c columns.c filled.c --samples=20 --min-samples=5 -- %{flags} 2>&1 | FileCheck %s
// CHECK: kernel changed, mode finite
// CHECK-NEXT: the wrapper was tried as well
// CHECK: kernel columns, mode finite
// CHECK-NEXT: the wrapper was tried as well
// CHECK: kernel filled, mode finite
// CHECK-NEXT: the wrapper was tried as well
// RUN: cd %t && %{c} %s -o original && ./original > expected
// RUN: cd %t && %cc -c changed.c columns.c filled.c && %{c} changed_wrapper.cpp changed.o columns.o filled.o -o swapped && ./swapped | diff expected -
#include <Eigen/Core>
#include <cstdio>

#pragma symreal function input(m, x) output(m)
static void changed(Eigen::Ref<Eigen::MatrixXd> m, Eigen::VectorXd const &x) {
  m(0, 0) = x[1];
  m(0, 1) = x[0] + x[1] + m(1, 0);
}
static double blocks() {
  Eigen::MatrixXd m(2, 2);
  m << 1, 2, 3, 4;
  Eigen::VectorXd x(2);
  x << 5, 6;
  changed(m, x);
  changed(m.block(0, 0, 2, 2), x);
  return m.sum();
}

#pragma symreal function input(x) output(return)
static double columns(Eigen::MatrixXd const &x) {
  double sum = 0;
  for (int i = 0; i < x.rows(); ++i) sum = sum * 2 + x(i, x.cols() - 1);
  return sum;
}

#pragma symreal function input(x) output(return)
static Eigen::Matrix2d filled(double x) {
  Eigen::Matrix2d result;
  result << x, 2 * x, 3 * x, x * x;
  return result;
}

int main() {
  double const sum = blocks(), wide = columns(Eigen::MatrixXd::Constant(2, 3, 1.5));
  std::printf("%.17g %.17g %.17g\n", sum, wide, columns(Eigen::MatrixXd::Constant(3, 2, 1.5)));
  for (double x : {1.5, -0.25}) {
    Eigen::Matrix2d const m = filled(x);
    std::printf("%g %g %g %g\n", m(0, 0), m(0, 1), m(1, 0), m(1, 1));
  }
}
