#include "algorithms.h"

#include <cmath>

namespace chain {

namespace {

// The base accelerates upwards instead of the links being pulled down.
SpatialVector base_acceleration() {
  SpatialVector a;
  a[5] = 9.80665;
  return a;
}

class Homogeneous {
public:
  Homogeneous() : elements_{} {
    for (int i = 0; i < 4; i++) elements_[i][i] = 1.0;
  }
  double &operator()(int row, int column) { return elements_[row][column]; }
  double const &operator()(int row, int column) const { return elements_[row][column]; }

  friend Homogeneous operator*(Homogeneous const &A, Homogeneous const &B) {
    Homogeneous result;
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        double sum = A(i, 0) * B(0, j);
        for (int k = 1; k < 4; k++) sum += A(i, k) * B(k, j);
        result(i, j) = sum;
      }
    }
    return result;
  }

private:
  double elements_[4][4];
};

} // namespace

void forward_kinematics(Model const &model, double const *q, double *pose) {
  Homogeneous T;
  for (int i = 0; i < model.size(); i++) {
    Link const &link = model.link(i);
    Homogeneous shift, turn;
    for (int k = 0; k < 3; k++) shift(k, 3) = link.offset[k];
    int const y = (link.axis + 1) % 3, z = (link.axis + 2) % 3;
    turn(y, y) = turn(z, z) = std::cos(q[i]);
    turn(z, y) = std::sin(q[i]);
    turn(y, z) = -turn(z, y);
    T = T * shift * turn;
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) pose[3 * i + j] = T(i, j);
    pose[9 + i] = T(i, 3);
  }
}

void inverse_dynamics(Model const &model, double const *q, double const *qd, double const *qdd, double *tau) {
  int const n = model.size();
  std::vector<SpatialMatrix> X(n);
  std::vector<SpatialVector> v(n), a(n), f(n);
  for (int i = 0; i < n; i++) {
    X[i] = rotation(model.link(i).axis, q[i]) * model.tree_transform(i);
    SpatialVector const joint_velocity = model.axis(i) * qd[i];
    SpatialVector const joint_acceleration = model.axis(i) * qdd[i];
    if (i == 0) {
      v[i] = joint_velocity;
      a[i] = X[i] * base_acceleration() + joint_acceleration;
    } else {
      v[i] = X[i] * v[i - 1] + joint_velocity;
      a[i] = X[i] * a[i - 1] + joint_acceleration + cross_motion(v[i]) * joint_velocity;
    }
    f[i] = model.inertia(i) * a[i] + cross_force(v[i]) * (model.inertia(i) * v[i]);
  }
  for (int i = n - 1; i >= 0; i--) {
    tau[i] = dot(model.axis(i), f[i]);
    if (i > 0) f[i - 1] += X[i].transpose() * f[i];
  }
}

void mass_matrix(Model const &model, double const *q, double *H) {
  int const n = model.size();
  std::vector<SpatialMatrix> X(n), composite(n);
  for (int i = 0; i < n; i++) {
    X[i] = rotation(model.link(i).axis, q[i]) * model.tree_transform(i);
    composite[i] = model.inertia(i);
  }
  for (int i = n - 1; i > 0; i--) composite[i - 1] += X[i].transpose() * composite[i] * X[i];
  for (int i = 0; i < n; i++) {
    SpatialVector force = composite[i] * model.axis(i);
    H[i * n + i] = dot(model.axis(i), force);
    for (int j = i; j > 0; j--) {
      force = X[j].transpose() * force;
      H[i * n + j - 1] = H[(j - 1) * n + i] = dot(model.axis(j - 1), force);
    }
  }
}

void forward_dynamics(Model const &model, double const *q, double const *qd, double const *tau, double *qdd) {
  int const n = model.size();
  std::vector<SpatialMatrix> X(n), inertia(n);
  std::vector<SpatialVector> v(n), c(n), bias(n), U(n);
  std::vector<double> d(n), u(n);
  for (int i = 0; i < n; i++) {
    X[i] = rotation(model.link(i).axis, q[i]) * model.tree_transform(i);
    SpatialVector const joint_velocity = model.axis(i) * qd[i];
    if (i == 0) {
      v[i] = joint_velocity;
    } else {
      v[i] = X[i] * v[i - 1] + joint_velocity;
      c[i] = cross_motion(v[i]) * joint_velocity;
    }
    inertia[i] = model.inertia(i);
    bias[i] = cross_force(v[i]) * (model.inertia(i) * v[i]);
  }
  for (int i = n - 1; i >= 0; i--) {
    U[i] = inertia[i] * model.axis(i);
    d[i] = dot(model.axis(i), U[i]);
    u[i] = tau[i] - dot(model.axis(i), bias[i]);
    if (i > 0) {
      SpatialVector k;
      for (int row = 0; row < 6; row++) k[row] = U[i][row] / d[i];
      SpatialMatrix const apparent = inertia[i] - outer_product(k, U[i]);
      SpatialVector const apparent_bias = bias[i] + apparent * c[i] + k * u[i];
      inertia[i - 1] += X[i].transpose() * apparent * X[i];
      bias[i - 1] += X[i].transpose() * apparent_bias;
    }
  }
  SpatialVector a = base_acceleration();
  for (int i = 0; i < n; i++) {
    a = X[i] * a;
    if (i > 0) a += c[i];
    qdd[i] = (u[i] - dot(U[i], a)) / d[i];
    a += model.axis(i) * qdd[i];
  }
}

} // namespace chain
