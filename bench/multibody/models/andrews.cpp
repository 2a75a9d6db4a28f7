// Andrews' squeezing mechanism: seven bodies in the plane, joined without friction, as the test set for initial-value
// problem solvers describes it (W. M. Lioen, J. J. B. de Swart, Test Set for IVP Solvers, 1998; E. Hairer, G. Wanner,
// Solving Ordinary Differential Equations II). In index-1 form: accelerations and multipliers solve M a + J^T lambda =
// f, J a = gamma.
#include "linear.h"
#include "model.h"

#include <cmath>

static double const m1 = 0.04325, m2 = 0.00365, m3 = 0.02373, m4 = 0.00706, m5 = 0.07050, m6 = 0.00706, m7 = 0.05498;
static double const i1 = 2.194e-6, i2 = 4.410e-7, i3 = 5.255e-6, i4 = 5.667e-7, i5 = 1.169e-5, i6 = 5.667e-7,
                    i7 = 1.912e-5;
static double const xb = -0.03635, yb = 0.03273, xc = 0.014, yc = 0.072, c0 = 4530, l0 = 0.07785, drive = 0.033;
static double const d = 0.028, da = 0.0115, e = 0.02, ea = 0.01421, rr = 0.007, ra = 0.00092, ss = 0.035, sa = 0.01874,
                    sb = 0.01043, sc = 0.018, sd = 0.02, ta = 0.02308, tb = 0.00916, u = 0.04, ua = 0.01228,
                    ub = 0.00449, zf = 0.02, zt = 0.04, fa = 0.01421;

static double square(double x) { return x * x; }

// state: beta, Theta, gamma, Phi, delta, Omega, epsilon, then their rates.
#pragma symreal function input(state[0 : 14]) output(rate[0 : 14])
void rates(double const *state, double *rate) {
  double const beta = state[0], theta = state[1], gamma = state[2], phi = state[3], delta = state[4], omega = state[5],
               epsilon = state[6];
  double const *v = state + 7;

  double M[7][7] = {}, f[7] = {};
  M[0][0] = m1 * square(ra) + m2 * (square(rr) - 2 * da * rr * std::cos(theta) + square(da)) + i1 + i2;
  M[1][0] = M[0][1] = m2 * (square(da) - da * rr * std::cos(theta)) + i2;
  M[1][1] = m2 * square(da) + i2;
  M[2][2] = m3 * (square(sa) + square(sb)) + i3;
  M[3][3] = m4 * square(e - ea) + i4;
  M[4][3] = M[3][4] = m4 * (square(e - ea) + zt * (e - ea) * std::sin(phi)) + i4;
  M[4][4] =
      m4 * (square(zt) + 2 * zt * (e - ea) * std::sin(phi) + square(e - ea)) + m5 * (square(ta) + square(tb)) + i4 + i5;
  M[5][5] = m6 * square(zf - fa) + i6;
  M[6][5] = M[5][6] = m6 * (square(zf - fa) - u * (zf - fa) * std::sin(omega)) + i6;
  M[6][6] = m6 * (square(zf - fa) - 2 * u * (zf - fa) * std::sin(omega) + square(u)) + m7 * (square(ua) + square(ub)) +
            i6 + i7;

  double const xd = sd * std::cos(gamma) + sc * std::sin(gamma) + xb,
               yd = sd * std::sin(gamma) - sc * std::cos(gamma) + yb;
  double const length = std::sqrt(square(xd - xc) + square(yd - yc)), spring = -c0 * (length - l0) / length;
  f[0] = drive - m2 * da * rr * v[1] * (v[1] + 2 * v[0]) * std::sin(theta);
  f[1] = m2 * da * rr * square(v[0]) * std::sin(theta);
  f[2] = spring * (xd - xc) * (sc * std::cos(gamma) - sd * std::sin(gamma)) +
         spring * (yd - yc) * (sd * std::cos(gamma) + sc * std::sin(gamma));
  f[3] = m4 * zt * (e - ea) * square(v[4]) * std::cos(phi);
  f[4] = -m4 * zt * (e - ea) * v[3] * (v[3] + 2 * v[4]) * std::cos(phi);
  f[5] = -m6 * u * (zf - fa) * square(v[6]) * std::cos(omega);
  f[6] = m6 * u * (zf - fa) * v[5] * (v[5] + 2 * v[6]) * std::cos(omega);

  // The loops close where the rod ends: rr e(beta) - d e(beta + Theta) meets each of three other bodies.
  double const bt = beta + theta, pd = phi + delta, oe = omega + epsilon;
  double J[6][7] = {};
  for (int k = 0; k < 3; k++) {
    J[2 * k][0] = -rr * std::sin(beta) + d * std::sin(bt);
    J[2 * k][1] = d * std::sin(bt);
    J[2 * k + 1][0] = rr * std::cos(beta) - d * std::cos(bt);
    J[2 * k + 1][1] = -d * std::cos(bt);
  }
  J[0][2] = -ss * std::cos(gamma);
  J[1][2] = -ss * std::sin(gamma);
  J[2][3] = -e * std::cos(pd);
  J[2][4] = -e * std::cos(pd) + zt * std::sin(delta);
  J[3][3] = -e * std::sin(pd);
  J[3][4] = -e * std::sin(pd) - zt * std::cos(delta);
  J[4][5] = zf * std::sin(oe);
  J[4][6] = zf * std::sin(oe) - u * std::cos(epsilon);
  J[5][5] = -zf * std::cos(oe);
  J[5][6] = -zf * std::cos(oe) - u * std::sin(epsilon);

  // gamma = -(dJ/dt) v
  double const wb = square(v[0]), wbt = square(v[0] + v[1]), wpd = square(v[3] + v[4]), woe = square(v[5] + v[6]);
  double const common_x = rr * std::cos(beta) * wb - d * std::cos(bt) * wbt;
  double const common_y = rr * std::sin(beta) * wb - d * std::sin(bt) * wbt;
  double const right[6] = {common_x - ss * std::sin(gamma) * square(v[2]),
                           common_y + ss * std::cos(gamma) * square(v[2]),
                           common_x - e * std::sin(pd) * wpd - zt * std::cos(delta) * square(v[4]),
                           common_y + e * std::cos(pd) * wpd - zt * std::sin(delta) * square(v[4]),
                           common_x - zf * std::cos(oe) * woe - u * std::sin(epsilon) * square(v[6]),
                           common_y - zf * std::sin(oe) * woe + u * std::cos(epsilon) * square(v[6])};

  // Columns of M^-1 [J^T f], then J M^-1 J^T lambda = J M^-1 f - gamma.
  double W[7][7];
  for (int c = 0; c < 7; c++) {
    double copy[7][7], column[7];
    for (int i = 0; i < 7; i++) {
      column[i] = c < 6 ? J[c][i] : f[i];
      for (int j = 0; j < 7; j++) copy[i][j] = M[i][j];
    }
    solve(copy, column);
    for (int i = 0; i < 7; i++) W[i][c] = column[i];
  }
  double A[6][6] = {}, lambda[6];
  for (int i = 0; i < 6; i++) {
    lambda[i] = -right[i];
    for (int k = 0; k < 7; k++) lambda[i] += J[i][k] * W[k][6];
    for (int j = 0; j < 6; j++)
      for (int k = 0; k < 7; k++) A[i][j] += J[i][k] * W[k][j];
  }
  solve(A, lambda);
  for (int i = 0; i < 7; i++) {
    rate[i] = v[i];
    rate[7 + i] = W[i][6];
    for (int k = 0; k < 6; k++) rate[7 + i] -= W[i][k] * lambda[k];
  }
}

void initial_state(double *state) {
  double const q[7] = {-0.0617138900142764496358948458001, 0,
                       0.455279819163070380255912382449,   0.222668390165885884674473185609,
                       0.487364979543842550225598953530,   -0.222668390165885884674473185609,
                       1.23054744454982119249735015568};
  for (int i = 0; i < 14; i++) state[i] = i < 7 ? q[i] : 0;
}

int main() { return print_rates(14); }
