#include <cstdio>
static double const curve[6] = {0.0, 1.5, 2.0, 1.0, -0.5, 3.0};
#pragma symreal function input(x) range(0, 5.9) output(return)
double kernel(double x) {
  int const i = (int)x;
  return curve[i] * x;
}
int main() { std::printf("%g\n", kernel(5.3)); }
