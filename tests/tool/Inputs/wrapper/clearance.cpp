#include "tables.h"
#include <bicycle.h>

namespace veh {
double clearance(Pose const &pose) { return clearance(pose, 1); }

#pragma symreal function input(pose.y, width) constant(grip_table) output(return)
double clearance(Pose const &pose, double width) {
  if (pose.y > 2) return grip_table[0];
  return pose.y * pose.y - width / 2;
}
} // namespace veh
