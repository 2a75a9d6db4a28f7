extern "C" {
#include "plain.h"
}
#include <cstdio>

extern "C" double third(double x) { return x / 3; }

int main() {
  double x = 12;
#pragma symreal input(x) range(1, 20)
  double const y = sixth(x) + half(x);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
