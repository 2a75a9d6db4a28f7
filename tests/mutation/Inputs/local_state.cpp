#include <cstdio>
#pragma symreal function input(x) constant(n) output(return)
double kernel(double x, int n) {
  static int factors[2];
  for (int i = 0; i < n; i++) factors[i] = 3 + i;
  return x * factors[1];
}
int main() { std::printf("%g\n", kernel(5.3, 2)); }
