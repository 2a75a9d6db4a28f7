#include <cstdio>
#include <vector>
#pragma symreal function input(x) output(return)
double kernel(std::vector<double> const &x) {
  double sum = 0;
  for (double const one : x) sum = 2 * sum + one;
  return sum;
}
int main() { std::printf("%g\n", kernel({0.5, 0.7, 0.9})); }
