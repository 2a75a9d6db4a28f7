#include <cstdio>
#pragma symreal function input(x) output(return)
double kernel(double x) {
#pragma STDC FENV_ROUND FE_UPWARD
  return x / 3;
}
int main() { std::printf("%g\n", kernel(5.3)); }
