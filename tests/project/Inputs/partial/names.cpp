#include "shared.h"
#include <cstdio>
double known(double x);
static Outer other;
int main() {
  double x = 3, y;
#pragma symreal input(x)
  Vector const v = halved({x});
  y = known(v.x) + (other.inner && spare() ? 1 : 0);
#pragma symreal output(y) generate("partial.c")
  std::printf("%g\n", y);
}
