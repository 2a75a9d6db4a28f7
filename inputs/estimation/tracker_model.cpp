// The model of inputs/kalman without its derivatives: a vehicle of unknown speed and yaw rate, seen by the range and the
// bearing of a beacon. State: x, y, heading, speed, yaw rate.
#include <cmath>
#include <cstdio>

#pragma symreal function input(x[0:5]) range(-2, 2) parameter(dt) output(next[0:5]) jacobian(next, x)
void motion(double const x[5], double dt, double next[5]) {
  double const middle = x[2] + x[4] * dt / 2.0, distance = x[3] * dt;
  next[0] = x[0] + distance * std::cos(middle);
  next[1] = x[1] + distance * std::sin(middle);
  next[2] = x[2] + x[4] * dt;
  next[3] = x[3];
  next[4] = x[4];
}

#pragma symreal function input(x[0:5]) range(-2, 2) parameter(beacon[0:2]) output(z[0:2]) jacobian(z, x)
void measurement(double const x[5], double const beacon[2], double z[2]) {
  double const dx = beacon[0] - x[0], dy = beacon[1] - x[1];
  z[0] = std::sqrt(dx * dx + dy * dy);
  z[1] = std::atan2(dy, dx) - x[2];
}

int main() {
  double const x[5] = {0.2, 0.1, 0.3, 4.0, 0.2}, beacon[2] = {20.0, -5.0};
  double next[5], z[2];
  motion(x, 0.1, next);
  measurement(next, beacon, z);
  for (double const number : next) std::printf("%.17g\n", number);
  for (double const number : z) std::printf("%.17g\n", number);
}
