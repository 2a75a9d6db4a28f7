#include "arm/arm.h"
#include "arm/table.h"

namespace arm {

double torque(Arm const &arm, double angle, double rate) {
  double sum = arm.length * gravity(arm.mass, angle);
  for (double each : arm.damping) sum += each * rate;
  return sum;
}

} // namespace arm
