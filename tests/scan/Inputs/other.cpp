#include "shared.h"
double other(double x) { return half(x); }
