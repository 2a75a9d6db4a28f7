#include <cstdio>
#pragma symreal function input(x) constant(n) output(return)
double kernel(double x, int n) {
  static int i;
  if (n > 0) i = 3;
  return x * i;
}
int main() { std::printf("%g\n", kernel(5.3, 1)); }
