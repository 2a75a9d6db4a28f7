#pragma once
#include <vector>
#pragma symreal function input(x) output(return)
inline double scaled(std::vector<double> const &x) {
  double sum = 0;
  for (double each : x) sum += 2 * each;
  return sum;
}
