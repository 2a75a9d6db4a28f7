#include <cstdio>
static double state;
static double next() { return state = state * 3.0 + 1.0; }
static double weigh(double a, double b) { return a - 7.0 * b; }
#pragma symreal function input(x) scratch(state) output(return)
double kernel(double x) {
  state = x;
  return weigh(next(), state);
}
int main() { std::printf("%g\n", kernel(5.3)); }
