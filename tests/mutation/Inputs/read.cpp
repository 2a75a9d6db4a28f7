#include <cstdio>
#pragma symreal function input(x) output(return)
double kernel(double const *gain, double x) { return gain[0] * x; }
int main() {
  double gain[1] = {2.5};
  std::printf("%g\n", kernel(gain, 5.3));
}
