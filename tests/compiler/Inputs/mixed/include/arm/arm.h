#pragma once

#include <vector>

namespace arm {

struct Arm {
  double mass = 2, length = 0.5;
  std::vector<double> damping;
};

double torque(Arm const &arm, double angle, double rate);

} // namespace arm
