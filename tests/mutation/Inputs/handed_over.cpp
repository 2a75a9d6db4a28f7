#include <cstdio>
struct Triple {
  double a, b, c;
};
#pragma symreal function input(x) output(*y)
Triple kernel(double x, double *y) {
  *y = x * x;
  return {x, *y, 3};
}
int main() {
  double y;
  Triple const triple = kernel(1.5, &y);
  std::printf("%g %g\n", y, triple.c);
}
