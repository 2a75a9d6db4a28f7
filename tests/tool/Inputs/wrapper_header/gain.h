#pragma once
#include "limits_of.h"

#pragma symreal function input(x) constant(steps) output(return)
inline double gain(double x, int steps) {
  double sum = least;
  for (int k = 0; k < steps; ++k) sum = sum * x + k;
  return sum;
}
