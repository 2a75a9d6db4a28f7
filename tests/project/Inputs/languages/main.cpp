extern "C" {
#include "plain.h"
extern const double scale[2];
}
#include "vector.h"
#include <cstdio>

extern "C" double third(double x) { return x / 3; }

int main() {
  double x = 12;
#pragma symreal input(x) range(1, 20)
  vector const v = rotated({0, x}) - vector{0, 1};
  double const y = sixth(x) + scale[1] * -v.x;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
