#include "step.h"

#include <math.h>

#pragma symreal function input(x[0:2], h) output(x[0:2])
void step(double x[2], double h) {
  double a = -sin(x[0]);
  x[0] += h * x[1] + HALF * h * h * a;
  x[1] += h * a;
}
