#include <cstdio>
#pragma symreal function input(x[0 : 2]) output(return)
double kernel(double const *x) {
  static double const first = x[0] * 2;
  return first * x[1];
}
int main() {
  double const x[2] = {0.5, 1.5};
  std::printf("%g\n", kernel(x));
}
