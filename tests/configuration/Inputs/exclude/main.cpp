#include "gravity.h"
#include "vendor/drag.h"
#include <cstdio>

double fall(double v) { return gravity(v) - drag(v); }

int main() {
  double v = 2;
  std::printf("%g\n", fall(v));
}
