#include "shapes.h"
#include <algorithm>
#include <cassert>
#include <cstdio>
static double total = 0;
double add(Circle const &circle) {
  assert(circle.radius > 0.5);
  total += std::max(area(circle), 1.0);
  std::printf("%s:%d %f\n", __FILE__, __LINE__, total);
  return total > 10 ? 10 : total;
}
