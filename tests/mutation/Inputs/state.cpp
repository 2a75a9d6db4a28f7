#include <cstdio>
static double gain = 2.5;
#pragma symreal function input(x) output(return)
double kernel(double x) { return gain * x; }
int main() {
  std::printf("%g\n", kernel(5.3));
  gain = 3.5;
}
