#include "arm/table.h"

#include <math.h>
#include <stdlib.h>

static const double g = 9.81;

double gravity(double mass, double angle) { return mass * g * cos(angle); }

joint *joints(int count) {
  joint *all = malloc(count * sizeof *all);
  for (int i = 0; i < count; ++i) all[i].angle = all[i].rate = 0;
  return all;
}
