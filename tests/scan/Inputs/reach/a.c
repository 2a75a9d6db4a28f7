#include "a.h"
#include <math.h>
static double gain = 2.0;
static double elsewhere = 1.0;
double (*law)(double) = 0;
double outside(double x);

static double never(double x) { return x * elsewhere; }
double other(double x) { return never(x); }

double step(double x) {
  int n = (int)x;
  double y = law ? law(x) : sin(x);
  return filtered(y * gain + n) + outside(x);
}
