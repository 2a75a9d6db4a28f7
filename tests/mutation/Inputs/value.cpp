#include <cstdio>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  std::printf("%g %d\n", x, x > 1);
  return 2 * x;
}
int main() { std::printf("%g\n", kernel(5.3)); }
