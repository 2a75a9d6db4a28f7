#include <algorithm>
#include <cstdio>
#pragma symreal function input(x) output(return)
double kernel(double x, double *work) {
  std::fill(work, work + 2, 3.0);
  return x * 2;
}
int main() {
  double work[2] = {1, 2};
  std::printf("%g %g\n", kernel(0.5, work), work[0]);
}
