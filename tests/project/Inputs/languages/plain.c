#include "plain.h"
#include <math.h>
#include <stdlib.h>
static double keep(double x) { return fabs(x) * abs(-1); }
double half(double x) { return keep(x) / 2; }
double sixth(double x) { return half(third(x)); }
