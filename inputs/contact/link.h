// A link that falls on the ground: a rod in the plane, with a contact at each end.
#pragma once

#include "contact_law.h"

#include <cmath>

struct Link {
  double mass, length, stiffness;
};

// The end `side` (-1 or 1) of the link at x, y, angle.
struct End {
  double position[2], velocity[2], arm[2];
};

inline End end_of(Link const &link, double const q[3], double const v[3], double side) {
  double const half = side * link.length / 2;
  double const arm[2] = {half * std::cos(q[2]), half * std::sin(q[2])};
  return {{q[0] + arm[0], q[1] + arm[1]}, {v[0] - arm[1] * v[2], v[1] + arm[0] * v[2]}, {arm[0], arm[1]}};
}

// Adds a force at an end to the link's accelerations.
inline void accelerate(Link const &link, End const &end, double const force[2], double a[3]) {
  a[0] += force[0] / link.mass;
  a[1] += force[1] / link.mass;
  a[2] += 12 * (end.arm[0] * force[1] - end.arm[1] * force[0]) / (link.mass * link.length * link.length);
}
