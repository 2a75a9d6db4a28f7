#include <cmath>
#include <cstdio>
using Function = double (*)(double);
static double derivative(Function f, double x) {
  if (f == static_cast<Function>(std::sin)) return std::cos(x);
  return f == static_cast<Function>(std::cos) ? -std::sin(x) : 0.0;
}
#pragma symreal function input(x) output(return)
double kernel(double x) { return derivative(std::sin, x) + x; }
int main() { std::printf("%g\n", kernel(0.7)); }
