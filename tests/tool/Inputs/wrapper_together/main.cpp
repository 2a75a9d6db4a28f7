#include "summed.h"
#include <cstdio>

double other(double x);

#pragma symreal function input(x) output(return)
double plain(double x) {
  if (x < 0) return -x;
  return x * x + 1;
}

namespace {
#pragma symreal function input(x) output(x)
void hidden(std::vector<double> &x) {
  for (double &each : x) each = each * each + 3;
}
} // namespace

int main() {
  std::vector<double> v = {1, 2};
  hidden(v);
  std::printf("%g %g %g %g %g\n", scaled(v), summed(v, 3), plain(2), plain(-2), other(3));
  std::vector<double> w = {1, 2, 3};
  hidden(w);
  std::printf("%g %g\n", w[2], scaled(w));
}
