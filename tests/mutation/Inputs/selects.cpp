#include <cstdio>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  double y = x;
  if (x > 5) y = 2 * x;
  return y;
}
int main() { std::printf("%g\n", kernel(5.3)); }
