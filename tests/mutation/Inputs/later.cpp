#include <cstdio>
static double state;
static double next() { return state = state * 3.0 + 1.0; }
#pragma symreal function input(x) scratch(state) output(return)
double kernel(double x) {
  state = x;
  return next() - 2.0 * next();
}
int main() { std::printf("%g\n", kernel(5.3)); }
