// The value that a kernel returns is the function's own type, however the expression behind `return` becomes one: an
// expression template, a conversion, an aggregate in braces. The caller's room for it is no state.
// RUN: %symreal generate %s -o %t/ --run-on -- -I/usr/include/eigen3
// RUN: %symreal verify %s %t/*.c --samples=50 -- -I/usr/include/eigen3 > %t.verified 2>&1
// RUN: FileCheck %s --input-file=%t.verified
// CHECK-COUNT-9: mode finite: 50 samples
#include <Eigen/Dense>
#include <array>
#include <complex>
#include <cstdio>

struct Pair {
  double a[2];
};
struct Sum {
  Pair const &x, &y;
  operator Pair() const { return {{x.a[0] + y.a[0], x.a[1] + y.a[1]}}; }
};
struct Triple {
  double a, b, c;
  Triple(Sum const &s) : a(s.x.a[0] + s.y.a[0]), b(s.x.a[1] + s.y.a[1]), c(a) {}
};
static Sum operator+(Pair const &x, Pair const &y) { return Sum{x, y}; }

#pragma symreal function input(q) output(return)
Eigen::Vector2d expression(Eigen::Vector2d const &q) { return q * 2 + q.cwiseProduct(q); }

#pragma symreal function input(q) output(return)
Eigen::MatrixXd sized(Eigen::Matrix2d q) { return q.transpose() * 2; }

#pragma symreal function input(q) output(return)
Eigen::Vector3d early(Eigen::Vector3d q) {
  if (q.size() == 3) return q.cross(Eigen::Vector3d(1, 2, 3));
  return {q[0], 0, 1};
}

#pragma symreal function input(q) output(return)
Pair converted(Pair const &q) { return q + q; }

#pragma symreal function input(q) output(return)
Triple constructed(Pair const &q) { return q + q; }

#pragma symreal function input(x) output(return)
std::array<double, 4> brace(double x) { return {x, x * x, 1, 2 * x}; }

#pragma symreal function input(x) output(return)
std::complex<double> complex(double x) { return {x * x, 3}; }

#pragma symreal function input(x) output(return)
double scalar(double x) { return {x * x}; }

// Nobody asks for what is returned.
#pragma symreal function input(q) output(*y)
Triple ignored(Pair const &q, double *y) {
  *y = q.a[0] * q.a[1];
  return q + q;
}

int main() {
  Eigen::Vector2d const r = expression(Eigen::Vector2d(1, 2));
  Eigen::MatrixXd const s = sized(Eigen::Matrix2d::Identity());
  Eigen::Vector3d const e = early(Eigen::Vector3d(1, 2, 4));
  Pair const q = {{1, 2}}, c = converted(q);
  Triple const t = constructed(q);
  std::array<double, 4> const b = brace(1.5);
  std::complex<double> const z = complex(1.5);
  double y = 0;
  Triple const i = ignored(q, &y);
  std::printf("%g\n", r[0] + s(0, 0) + e[1] + c.a[0] + t.a + b[1] + z.real() + scalar(3) + y + (sizeof i));
}
