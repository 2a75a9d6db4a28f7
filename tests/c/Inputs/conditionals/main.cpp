#include "shared.h"
#include <cstdio>

double from_cpp(double x) { return doubled(x) * FACTOR; }

int main() {
  double x = 3, y;
#pragma symreal input(x)
  y = scaled(x);
#pragma symreal output(y) generate("y.c")
  std::printf("%.17g\n", y);
}
