#include <cstdio>
#include <vector>
#pragma symreal function input(x) output(return)
double kernel(double const *raw, double x) {
  std::vector<double> const copy(raw, raw + 2);
  return x * copy[0];
}
int main() {
  double raw[2] = {21, 22};
  std::printf("%g\n", kernel(raw, 5.3));
}
