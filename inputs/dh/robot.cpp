#include "robot.h"

#include <cstdio>

namespace dh {

Inertia unpack(double const *p) {
  return {p[0], {p[1], p[2], p[3]}, {{{p[4], p[5], p[6]}, {p[5], p[7], p[8]}, {p[6], p[8], p[9]}}}};
}

// Steiner's theorem.
void pack(double *p, double mass, Vec3 c, double const inertia[6]) {
  p[0] = mass;
  p[1] = mass * c.x;
  p[2] = mass * c.y;
  p[3] = mass * c.z;
  p[4] = inertia[0] + mass * (c.y * c.y + c.z * c.z);
  p[5] = inertia[1] - mass * c.x * c.y;
  p[6] = inertia[2] - mass * c.x * c.z;
  p[7] = inertia[3] + mass * (c.x * c.x + c.z * c.z);
  p[8] = inertia[4] - mass * c.y * c.z;
  p[9] = inertia[5] + mass * (c.x * c.x + c.y * c.y);
}

Robot rx90() {
  Robot robot;
  robot.joints = {{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, .45, 0}, {0, -1, 0, .45}, {0, 1, 0, 0}, {0, -1, 0, 0}};
  robot.gravity = {0, 0, -9.81};
  return robot;
}

std::vector<double> rx90_parameters() {
  std::vector<double> parameters(6 * INERTIA_SIZE);
  for (int i = 1; i <= 6; i++) {
    Vec3 const centre = {.11 + .01 * i, .07 - .02 * i, .05 + .03 * i};
    double const inertia[6] = {.5 + .05 * i, .02 + .003 * i,  -.03 + .002 * i,
                               .6 + .04 * i, .015 + .001 * i, .7 + .03 * i};
    pack(&parameters[(i - 1) * INERTIA_SIZE], 1.1 + .3 * i, centre, inertia);
  }
  return parameters;
}

Robot planar(int n) {
  Robot robot;
  for (int i = 0; i < n; i++) robot.joints.push_back({1, 0, i == 0 ? 0. : .8, 0});
  robot.gravity = {0, -9.81, 0};
  return robot;
}

std::vector<double> planar_parameters(int n) {
  std::vector<double> parameters(n * INERTIA_SIZE);
  for (int i = 1; i <= n; i++) {
    double const inertia[6] = {.01, 0, 0, .2 + .01 * i, 0, .21 + .02 * i};
    pack(&parameters[(i - 1) * INERTIA_SIZE], 1.1 + .3 * i, {.4 + .01 * i, 0, 0}, inertia);
  }
  return parameters;
}

std::vector<double> steps(int n, double first, double step) {
  std::vector<double> values;
  for (int i = 0; i < n; i++) values.push_back(first + step * i);
  return values;
}

void print(std::vector<double> const &values) {
  for (double value : values) std::printf("%.17g\n", value);
}

} // namespace dh
