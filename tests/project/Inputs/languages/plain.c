#include "plain.h"
#include "vector.h"
#include <math.h>
#include <stdlib.h>
const double scale[2] = {1, 0.5};
static double keep(double x) { return fabs(x) * abs(-1); }
double half(double x) { return keep(x) / 2; }
double sixth(double x) { return half(third(x)); }
vector rotated(vector v) {
  vector const w = {-v.y, v.x};
  return w;
}
