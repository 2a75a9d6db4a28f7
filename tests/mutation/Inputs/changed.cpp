#include <cstdio>
#include <vector>
#pragma symreal function input(x) output(return)
double kernel(std::vector<double> &history, double x) {
  history.push_back(2.0 * x);
  return x * x;
}
int main() {
  std::vector<double> history{1.0};
  history.reserve(4000);
  std::printf("%g\n", kernel(history, 5.3));
}
