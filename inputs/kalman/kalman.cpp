// One step of an extended Kalman filter: a vehicle of unknown speed and yaw rate is followed by the range and the
// bearing of a beacon whose place is known.
//
// State: x, y, heading, speed, yaw rate. Measurement: range, bearing relative to the heading.
#include <cmath>
#include <cstdio>

enum { STATES = 5, MEASUREMENTS = 2 };

struct Settings {
  double dt;
  double sigma_acceleration;     // process noise: along the track
  double sigma_yaw_acceleration; // and about the vertical
  double sigma_drift;            // and sideways, metres in a second
  double sigma_range;            // measurement noise
  double sigma_bearing;
  double beacon[2];
};

// P = A * B
static void multiply(double const A[STATES][STATES], double const B[STATES][STATES], double P[STATES][STATES]) {
  for (int i = 0; i < STATES; i++) {
    for (int j = 0; j < STATES; j++) {
      P[i][j] = 0.0;
      for (int k = 0; k < STATES; k++) P[i][j] += A[i][k] * B[k][j];
    }
  }
}

// Covariance of what white accelerations add in one time step.
static void process_noise(Settings const &s, double Q[STATES][STATES]) {
  double const acceleration = s.sigma_acceleration * s.sigma_acceleration;
  double const yaw_acceleration = s.sigma_yaw_acceleration * s.sigma_yaw_acceleration;
  double const drift = s.sigma_drift * s.sigma_drift * s.dt;
  for (int i = 0; i < STATES; i++)
    for (int j = 0; j < STATES; j++) Q[i][j] = 0.0;
  Q[0][0] = Q[1][1] = drift + acceleration * std::pow(s.dt, 4) / 4.0;
  Q[2][2] = yaw_acceleration * std::pow(s.dt, 4) / 4.0;
  Q[2][4] = Q[4][2] = yaw_acceleration * std::pow(s.dt, 3) / 2.0;
  Q[3][3] = acceleration * s.dt * s.dt;
  Q[4][4] = yaw_acceleration * s.dt * s.dt;
}

static void predict(double x[STATES], double P[STATES][STATES], Settings const &s) {
  double const middle = x[2] + x[4] * s.dt / 2.0;
  double const distance = x[3] * s.dt;
  double F[STATES][STATES] = {{0.0}};
  for (int i = 0; i < STATES; i++) F[i][i] = 1.0;
  F[0][2] = -distance * std::sin(middle);
  F[0][3] = s.dt * std::cos(middle);
  F[0][4] = -distance * std::sin(middle) * s.dt / 2.0;
  F[1][2] = distance * std::cos(middle);
  F[1][3] = s.dt * std::sin(middle);
  F[1][4] = distance * std::cos(middle) * s.dt / 2.0;
  F[2][4] = s.dt;

  x[0] += distance * std::cos(middle);
  x[1] += distance * std::sin(middle);
  x[2] += x[4] * s.dt;

  double Ft[STATES][STATES], FP[STATES][STATES], Q[STATES][STATES];
  for (int i = 0; i < STATES; i++)
    for (int j = 0; j < STATES; j++) Ft[i][j] = F[j][i];
  multiply(F, P, FP);
  multiply(FP, Ft, P);
  process_noise(s, Q);
  for (int i = 0; i < STATES; i++)
    for (int j = 0; j < STATES; j++) P[i][j] += Q[i][j];
}

static void update(double x[STATES], double P[STATES][STATES], double const z[MEASUREMENTS], Settings const &s) {
  double const dx = s.beacon[0] - x[0], dy = s.beacon[1] - x[1];
  double const squared = dx * dx + dy * dy, range = std::sqrt(squared);
  double H[MEASUREMENTS][STATES] = {{0.0}};
  H[0][0] = -dx / range;
  H[0][1] = -dy / range;
  H[1][0] = dy / squared;
  H[1][1] = -dx / squared;
  H[1][2] = -1.0;

  // The difference of two bearings is brought back to (-pi, pi].
  double const bearing = z[1] - (std::atan2(dy, dx) - x[2]);
  double const innovation[MEASUREMENTS] = {z[0] - range, std::atan2(std::sin(bearing), std::cos(bearing))};

  double PHt[STATES][MEASUREMENTS], S[MEASUREMENTS][MEASUREMENTS], K[STATES][MEASUREMENTS];
  for (int i = 0; i < STATES; i++) {
    for (int j = 0; j < MEASUREMENTS; j++) {
      PHt[i][j] = 0.0;
      for (int k = 0; k < STATES; k++) PHt[i][j] += P[i][k] * H[j][k];
    }
  }
  for (int i = 0; i < MEASUREMENTS; i++) {
    for (int j = 0; j < MEASUREMENTS; j++) {
      S[i][j] = 0.0;
      for (int k = 0; k < STATES; k++) S[i][j] += H[i][k] * PHt[k][j];
    }
  }
  S[0][0] += s.sigma_range * s.sigma_range;
  S[1][1] += s.sigma_bearing * s.sigma_bearing;

  double const determinant = S[0][0] * S[1][1] - S[0][1] * S[1][0];
  double const inverse[MEASUREMENTS][MEASUREMENTS] = {{S[1][1] / determinant, -S[0][1] / determinant},
                                                      {-S[1][0] / determinant, S[0][0] / determinant}};
  for (int i = 0; i < STATES; i++) {
    for (int j = 0; j < MEASUREMENTS; j++) {
      K[i][j] = 0.0;
      for (int k = 0; k < MEASUREMENTS; k++) K[i][j] += PHt[i][k] * inverse[k][j];
    }
  }
  for (int i = 0; i < STATES; i++)
    for (int j = 0; j < MEASUREMENTS; j++) x[i] += K[i][j] * innovation[j];

  double reduce[STATES][STATES], before[STATES][STATES];
  for (int i = 0; i < STATES; i++) {
    for (int j = 0; j < STATES; j++) {
      reduce[i][j] = i == j ? 1.0 : 0.0;
      for (int k = 0; k < MEASUREMENTS; k++) reduce[i][j] -= K[i][k] * H[k][j];
      before[i][j] = P[i][j];
    }
  }
  multiply(reduce, before, P);
}

#pragma symreal function input(x[0:5], P[0:5][0:5], z[0:2]) parameter(settings[0:8]) output(x[0:5], P[0:5][0:5])
void filter_step(double x[5], double P[5][5], double const z[2], double const settings[8]) {
  Settings const s = {
      settings[0], settings[1], settings[2], settings[3], settings[4], settings[5], {settings[6], settings[7]}};
  predict(x, P, s);
  update(x, P, z, s);
}

int main() {
  double const settings[8] = {0.1, 0.8, 0.3, 0.05, 0.25, 0.02, 20.0, -5.0};
  double const measurements[3][2] = {{20.3, -0.52}, {20.1, -0.57}, {19.6, -0.61}};
  double x[STATES] = {0.2, 0.1, 0.3, 4.0, 0.2};
  double P[STATES][STATES] = {{0.0}};
  double const deviations[STATES] = {0.5, 0.5, 0.1, 0.4, 0.05};
  for (int i = 0; i < STATES; i++) P[i][i] = deviations[i] * deviations[i];

  for (int step = 0; step < 3; step++) {
    filter_step(x, P, measurements[step], settings);
    for (int i = 0; i < STATES; i++) std::printf("%.17g%c", x[i], i + 1 < STATES ? ' ' : '\n');
  }
  for (int i = 0; i < STATES; i++)
    for (int j = 0; j < STATES; j++) std::printf("%.17g%c", P[i][j], j + 1 < STATES ? ' ' : '\n');
}
