#include "joint.h"
#include <cstdio>
int main() {
  double q = 2, y;
  Revolute const r;
  Joint const &joint = r;
#pragma symreal input(q)
  y = joint.at(q);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
