#include "lib.h"

#pragma symreal function input(x) output(return)
std::complex<double> root(double x) {
  std::complex<double> result(x * x, x + 1);
  return result;
}

#pragma symreal function input(x) output(return)
std::array<double, 3> powers(double x) {
  std::array<double, 3> result;
  result[0] = x;
  result[1] = x * x;
  result[2] = x * x * x;
  return result;
}

#pragma symreal function input(x) output(return)
std::vector<double> series(double x) {
  std::vector<double> result(4);
  for (int k = 0; k < 4; ++k) result[k] = x + k;
  return result;
}

#pragma symreal function input(x) output(return)
Pose pose(double x) {
  Pose result;
  result.at[0] = x;
  result.at[1] = 2 * x;
  result.heading.angle = x - 1;
  result.joints.resize(2);
  result.joints[0] = x * x;
  result.joints[1] = x + 4;
  result.phase = std::complex<double>(x, 3 * x);
  return result;
}

#pragma symreal function input(x) output(return)
Hidden hidden(double x) {
  Hidden result(x, x * x);
  return result;
}

#pragma symreal function input(x) output(return)
std::pair<double, double> both(double x) {
  std::pair<double, double> result(x + 1, x - 1);
  return result;
}
