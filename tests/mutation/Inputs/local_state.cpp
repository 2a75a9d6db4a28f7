#include <cstdio>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  static int i;
  for (i = 0; i < 3; i++) x = x * 1.5;
  return x;
}
int main() { std::printf("%g\n", kernel(5.3)); }
