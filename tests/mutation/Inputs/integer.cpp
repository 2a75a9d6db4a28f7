#include <cstdio>
#pragma symreal function input(x) range(-9, 9) output(return)
double kernel(double x) {
  int i = (int)x;
  unsigned u = i - 6;
  return x * i + u;
}
int main() { std::printf("%g\n", kernel(5.3)); }
