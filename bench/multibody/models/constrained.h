// Rigid bodies in the plane under constraint equations, in index-1 form: the multipliers solve J M^-1 J^T lambda =
// gamma - J M^-1 f, and Baumgarte's terms pull position and velocity back to the constraints.
#pragma once

#include "linear.h"

#include <cmath>

struct PlanarBody {
  double mass, inertia;
};

// A point of one body on a point of another; body -1 is the ground.
struct Revolute {
  int a, b;
  double point_a[2], point_b[2];
};

template <int bodies, int revolutes, int guides> struct Mechanism {
  static constexpr int coordinates = 3 * bodies, constraints = 2 * revolutes + 2 * guides;
  PlanarBody body[bodies];
  Revolute revolute[revolutes];
  int guide[guides + 1]; // bodies that slide along the x axis and do not turn
  double drive, damping; // a moment on body 0, and on it against its angular velocity
  double stiffness;      // Baumgarte's: both terms critically damped
};

// state: x, y, angle of each body, then their rates.
template <int bodies, int revolutes, int guides>
void mechanism_rates(Mechanism<bodies, revolutes, guides> const &mechanism, double const *state, double *rate) {
  constexpr int n = 3 * bodies, m = 2 * revolutes + 2 * guides;
  double const *q = state, *v = state + n;
  double J[m][n] = {}, error[m] = {}, gamma[m] = {}, force[n] = {}, inverse_mass[n];
  for (int i = 0; i < bodies; i++) {
    inverse_mass[3 * i] = inverse_mass[3 * i + 1] = 1 / mechanism.body[i].mass;
    inverse_mass[3 * i + 2] = 1 / mechanism.body[i].inertia;
    force[3 * i + 1] = -9.81 * mechanism.body[i].mass;
  }
  force[2] += mechanism.drive - mechanism.damping * v[2];

  for (int k = 0; k < revolutes; k++) {
    Revolute const &joint = mechanism.revolute[k];
    for (int side = 0; side < 2; side++) {
      int const body = side == 0 ? joint.a : joint.b;
      double const *point = side == 0 ? joint.point_a : joint.point_b;
      double const sign = side == 0 ? 1 : -1;
      double x = point[0], y = point[1];
      if (body >= 0) {
        int const c = 3 * body;
        double const cosine = std::cos(q[c + 2]), sine = std::sin(q[c + 2]);
        double const rx = cosine * x - sine * y, ry = sine * x + cosine * y;
        J[2 * k][c] = J[2 * k + 1][c + 1] = sign;
        J[2 * k][c + 2] = -sign * ry;
        J[2 * k + 1][c + 2] = sign * rx;
        gamma[2 * k] += sign * v[c + 2] * v[c + 2] * rx;
        gamma[2 * k + 1] += sign * v[c + 2] * v[c + 2] * ry;
        x = q[c] + rx;
        y = q[c + 1] + ry;
      }
      error[2 * k] += sign * x;
      error[2 * k + 1] += sign * y;
    }
  }
  for (int k = 0; k < guides; k++) {
    int const row = 2 * revolutes + 2 * k, c = 3 * mechanism.guide[k];
    J[row][c + 1] = J[row + 1][c + 2] = 1;
    error[row] = q[c + 1];
    error[row + 1] = q[c + 2];
  }

  double A[m][m], lambda[m];
  for (int i = 0; i < m; i++) {
    double velocity_error = 0;
    for (int k = 0; k < n; k++) velocity_error += J[i][k] * v[k];
    lambda[i] =
        gamma[i] - 2 * mechanism.stiffness * velocity_error - mechanism.stiffness * mechanism.stiffness * error[i];
    for (int k = 0; k < n; k++) lambda[i] -= J[i][k] * inverse_mass[k] * force[k];
    for (int j = 0; j < m; j++) {
      A[i][j] = 0;
      for (int k = 0; k < n; k++) A[i][j] += J[i][k] * inverse_mass[k] * J[j][k];
    }
  }
  solve(A, lambda);
  for (int k = 0; k < n; k++) {
    double sum = force[k];
    for (int i = 0; i < m; i++) sum += J[i][k] * lambda[i];
    rate[k] = v[k];
    rate[n + k] = inverse_mass[k] * sum;
  }
}
