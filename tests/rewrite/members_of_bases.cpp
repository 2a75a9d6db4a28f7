// A class tells its bases as they are called after the rewriting.
// RUN: %same %s -- -I/usr/include/eigen3
// RUN: %rewrite %s -- -I/usr/include/eigen3 | FileCheck %s
// RUN: %if all %{ %symreal generate %s --frozen=allow -o %t.c -- -I/usr/include/eigen3 && %symreal verify %s %t.c --samples=100 -- -I/usr/include/eigen3 %}
#include <Eigen/Dense>
#include <cstdio>
#include <vector>

// CHECK: class Axis : public Eigen::Vector3<REAL>
// CHECK-NEXT: { REAL_MEMBERS(private, static_cast<Eigen::Vector3<REAL> const &>(*this), scale_)
class Axis : public Eigen::Vector3d
{
  double scale_;

public:
  Axis(double x, double y, double z) : Eigen::Vector3d(x, y, z), scale_(2) {}
  double scale() const { return scale_; }
};

// CHECK: struct Chain : std::vector<REAL>
// CHECK-NEXT: { REAL_MEMBERS(public, static_cast<std::vector<REAL> const &>(*this))
struct Chain : std::vector<double>
{
  using std::vector<double>::vector;
};

struct Model {
  Axis axis{1, 2, 3};
  Chain chain = Chain(3, 0.5);
  Eigen::MatrixXd frame = Eigen::MatrixXd::Ones(3, 3);
};

#pragma symreal function input(x[0:3]) parameter(model->axis, model->frame, model->chain) output(return)
double kernel(Model *model, Eigen::Vector3d &x) {
  // A transposed product has no elements in memory; those of its factors are looked at.
  Eigen::RowVector3d const turned = (model->frame.transpose() * model->axis).transpose();
  return turned.dot(x) + model->chain[0];
}

int main() {
  Model model;
  Eigen::Vector3d x(1, 2, 3);
  std::printf("%g\n", kernel(&model, x));
}
