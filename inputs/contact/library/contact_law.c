#include "../contact_law.h"

#include <math.h>

static double const friction = 0.6, creep = 1e-3;

static double normal_force(double stiffness, double depth, double speed) {
  double const force = stiffness * depth * (1 - 0.4 * speed);
  return force > 0 ? force : 0;
}

void contact_force(double stiffness, double const position[2], double const velocity[2], double force[2]) {
  force[0] = force[1] = 0;
  if (position[1] >= 0) return;
  force[1] = normal_force(stiffness, -position[1], velocity[1]);
  force[0] = -friction * force[1] * velocity[0] / (fabs(velocity[0]) + creep);
}

struct anchor sticking_force(int point, double stiffness, double const position[2], double const velocity[2],
                             double force[2]) {
  static struct anchor anchors[8];
  struct anchor *anchor = &anchors[point];
  double limit;
  force[0] = force[1] = 0;
  if (position[1] >= 0) {
    anchor->holds = 0;
    return *anchor;
  }
  if (anchor->holds == 0) anchor->x = position[0];
  anchor->holds = 1;
  force[1] = normal_force(stiffness, -position[1], velocity[1]);
  limit = friction * force[1];
  force[0] = stiffness * (anchor->x - position[0]);
  if (fabs(force[0]) > limit) {
    force[0] = copysign(limit, force[0]);
    anchor->x = position[0] + force[0] / stiffness;
  }
  return *anchor;
}
