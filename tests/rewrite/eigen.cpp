// Eigen's typedefs become their templates on REAL, spelled without a comma where Eigen has such a name.
// What a macro of a library does is the library's.
// RUN: %rewrite %s -- -I/usr/include/eigen3 2>&1 | FileCheck %s --implicit-check-not='SYM{{040}}'
// RUN: %if all %{ %same %s -- -I/usr/include/eigen3 %}
// RUN: rm -rf %t && mkdir %t && cp %s %t/e.cpp && cd %t && %symreal rewrite e.cpp --out-root once -- -I/usr/include/eigen3
// RUN: cd %t/once && %symreal rewrite e.cpp --diff -- -I/usr/include/eigen3 | count 0
#include <Eigen/Dense>
#include <Eigen/StdVector>

// CHECK: EIGEN_DEFINE_STL_VECTOR_SPECIALIZATION(Eigen::Matrix4<REAL>)
EIGEN_DEFINE_STL_VECTOR_SPECIALIZATION(Eigen::Matrix4d)

// CHECK: using Twist = Eigen::Matrix<REAL, 6, 1>;
using Twist = Eigen::Matrix<double, 6, 1>;
// CHECK: REAL f(Eigen::Matrix3<REAL> const &m, Eigen::VectorX<REAL> v) {
double f(Eigen::Matrix3d const &m, Eigen::VectorXd v) {
  using namespace Eigen;
  // CHECK: Eigen::Vector3<REAL> a(1.0, 2.0, 3.0); Eigen::Quaternion<REAL> q = Eigen::Quaternion<REAL>::Identity();
  Vector3d a(1.0, 2.0, 3.0); Quaterniond q = Quaterniond::Identity();
  // CHECK: Eigen::Vector2<REAL> b(REAL_C(1.0), REAL_C(2.0));
  Vector2d b(1.0, 2.0);
  // CHECK: Map<Eigen::MatrixX<REAL>> map(v.data(), 1, v.size());
  Map<MatrixXd> map(v.data(), 1, v.size());
  // CHECK: a = REAL_C(0.5) * (REAL_READ({{.*}}, m) * a) / REAL_C(2.0) + Eigen::Vector3<REAL>::Zero();
  a = 0.5 * (m * a) / 2.0 + Vector3d::Zero();
  // CHECK: Eigen::Transform<REAL, 3, {{.*}}> t = {{.*}}::Identity();
  Isometry3d t = Isometry3d::Identity();
  a *= 0.25;
  return a.dot(q * a) + map(0, 0) + (t * a).norm() + b(1);
}

// A function that prints what it is keeps the typedef's name in numeric mode.
struct Solver {
  // CHECK: bool solve(Eigen::REAL_TYPE(VectorXd, VectorX<REAL>) const &v, REAL tolerance);
  bool solve(Eigen::VectorXd const &v, double tolerance);
};
// CHECK: bool Solver::solve(Eigen::REAL_TYPE(VectorXd, VectorX<REAL>) const &v, REAL tolerance) {
bool Solver::solve(Eigen::VectorXd const &v, double tolerance) {
  assert(v.size() > 2);
  // CHECK: Eigen::VectorX<REAL> w =
  Eigen::VectorXd w = v * tolerance;
  return w.size() == 3;
}
