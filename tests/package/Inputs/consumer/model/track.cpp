#include "track.h"

#pragma symreal function input(position, rate) output(return)
double track(double position, double rate) {
  double sum = 0;
  for (int i = 0; i < GAIN; ++i) sum += position;
  return sum + offset * rate;
}
