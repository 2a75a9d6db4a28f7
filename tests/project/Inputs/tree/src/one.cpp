#include "body.h"
#include <cstdio>
double one(double x) {
  std::printf("%s %f\n", __FILE__, x);
#ifdef SECOND
  double second = x + SECOND;
  x = second;
#endif
  return weight(x);
}
