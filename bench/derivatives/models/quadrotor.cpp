// A quadrotor as a rigid body: place, quaternion, velocity and angular velocity in the body; thrusts of four rotors,
// linear and quadratic drag, gyroscopic moments. x: the 13 states, the 4 speeds of the rotors; z: the mass; y: the
// rates of the states.
#include <cmath>

void model(double const *x, double const *z, double *y) {
  double const mass = z[0], arm = 0.17, g = 9.80665, lift = 6.1e-6, torque = 1.1e-7, rotor = 6e-5;
  double const inertia[3] = {0.0052, 0.0049, 0.0091}, linear[3] = {0.11, 0.12, 0.19}, quadratic = 0.021;
  double const *q = x + 3, *v = x + 7, *w = x + 10, *speed = x + 13;
  double thrust[4], total = 0.0, spin = 0.0, drag = 0.0;
  for (int i = 0; i < 4; i++) {
    thrust[i] = lift * speed[i] * speed[i];
    total += thrust[i];
    spin += (i % 2 ? 1.0 : -1.0) * speed[i];
    drag += (i % 2 ? -1.0 : 1.0) * torque * speed[i] * speed[i];
  }
  double const size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  double const a = q[0] / size, b = q[1] / size, c = q[2] / size, d = q[3] / size;
  double const R[3][3] = {{1.0 - 2.0 * (c * c + d * d), 2.0 * (b * c - a * d), 2.0 * (b * d + a * c)},
                          {2.0 * (b * c + a * d), 1.0 - 2.0 * (b * b + d * d), 2.0 * (c * d - a * b)},
                          {2.0 * (b * d - a * c), 2.0 * (c * d + a * b), 1.0 - 2.0 * (b * b + c * c)}};
  double const wind = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + 1e-6);
  for (int i = 0; i < 3; i++) {
    y[i] = R[i][0] * v[0] + R[i][1] * v[1] + R[i][2] * v[2];
    int const j = (i + 1) % 3, k = (i + 2) % 3;
    double const push = i == 2 ? total : 0.0;
    y[7 + i] = (push - linear[i] * v[i] - quadratic * wind * v[i]) / mass - g * R[2][i] + v[j] * w[k] - v[k] * w[j];
  }
  y[3] = 0.5 * (-b * w[0] - c * w[1] - d * w[2]);
  y[4] = 0.5 * (a * w[0] + c * w[2] - d * w[1]);
  y[5] = 0.5 * (a * w[1] + d * w[0] - b * w[2]);
  y[6] = 0.5 * (a * w[2] + b * w[1] - c * w[0]);
  double const moment[3] = {arm * (thrust[1] - thrust[3]) - rotor * spin * w[1],
                            arm * (thrust[2] - thrust[0]) + rotor * spin * w[0], drag};
  for (int i = 0; i < 3; i++) {
    int const j = (i + 1) % 3, k = (i + 2) % 3;
    y[10 + i] = (moment[i] - (inertia[k] - inertia[j]) * w[j] * w[k]) / inertia[i];
  }
}
