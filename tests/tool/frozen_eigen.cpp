// Objects of Eigen that are members: what its compiled templates read of them is seen where they are used.
// RUN: not %symreal generate %s -o %t.c -- -I/usr/include/eigen3 2>&1 | FileCheck %s
// RUN: %symreal generate %s -o %t.c --frozen=allow -- -I/usr/include/eigen3 2>&1 | FileCheck %s --check-prefix=LISTED
// RUN: %if all %{ %symreal verify %s %t.c --samples=100 -- -I/usr/include/eigen3 %}
#include <Eigen/Dense>

#include <cstdio>
#include <vector>

class Observer {
public:
  Observer() : gain_(2, 2), offset_(2), parts_(2, Eigen::VectorXd::Constant(2, 7.0)) {
    gain_ << 1, 2, 3, 4;
    offset_ << 5, 6;
    scratch_.setOnes();
  }

  Eigen::VectorXd step(Eigen::VectorXd const &x, Eigen::Ref<Eigen::VectorXd const> bias, double const *raw) {
    scratch_ = gain_ * x;
    scratch_.head<1>() = x.head<1>();
    Eigen::Map<Eigen::Vector2d const> const map(raw);
    Eigen::VectorXd y = scratch_ + offset_ + parts_[1].tail<2>() * x[0] + bias;
    y.noalias() += rotation_ * map;
    y[0] += offset_(0) + gain_.col(1).sum() * x[1];
    return y;
  }

private:
  Eigen::MatrixXd gain_;
  Eigen::VectorXd offset_, scratch_{2};
  std::vector<Eigen::VectorXd> parts_;
  Eigen::Matrix2d rotation_ = Eigen::Matrix2d::Identity();
};

#pragma symreal function input(x) scratch(observer) output(y)
void step(Observer &observer, Eigen::VectorXd &x, Eigen::VectorXd const &bias, double const *raw, Eigen::VectorXd &y) {
  y = observer.step(x, bias, raw);
}

int main() {
  double raw[2] = {0.25, 0.75};
  Observer observer;
  Eigen::VectorXd x(2), bias(2), y;
  x << 0.5, 1.5;
  bias << 8, 9;
  step(observer, x, bias, raw, y);
  std::printf("%g\n", y[0]);
}

// CHECK: frozen_eigen.cpp:19:16: error: kernel 'step' reads 'gain_' (1, 2, 3, 4), which are neither
// CHECK: frozen_eigen.cpp:22:36: error: kernel 'step' reads 'offset_' (5, 6), which are neither
// CHECK: frozen_eigen.cpp:22:46: error: kernel 'step' reads 'parts_[1].tail<2>()' (7, 7), which are neither
// CHECK: frozen_eigen.cpp:23:20: error: kernel 'step' reads 'rotation_' (1, 0, 0, 1), which are neither
// CHECK: frozen_eigen.cpp:23:32: error: kernel 'step' reads 'map' (0.25, 0.75), which are neither
// CHECK: frozen_eigen.cpp:37:24: error: kernel 'step' reads 'bias' (8, 9), which are neither input nor parameter [SYM017]
// CHECK-NOT: SYM017]
// LISTED: baked in        gain_ = 1, 2, 3, 4  ({{.*}}frozen_eigen.cpp:19:16)
