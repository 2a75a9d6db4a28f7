#include "arm/arm.h"
#include "arm/table.h"

#include <cstdio>
#include <cstdlib>

int main() {
  arm::Arm arm;
  arm.damping = {0.25, 0.5};
  joint *joint = joints(1);
  joint->angle = 0.3;
  joint->rate = 2;
#pragma symreal input(joint->angle, joint->rate) constant(arm)
  double tau = torque(arm, joint->angle, joint->rate);
#pragma symreal output(tau) generate("swing.c")
  std::printf("%s:%d: %.17g\n", __FILE__, __LINE__, tau);
  std::free(joint);
}
