#include <cstdio>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  long double const third = static_cast<long double>(x) / 3;
  return static_cast<double>(third * third);
}
int main() { std::printf("%g\n", kernel(5.3)); }
