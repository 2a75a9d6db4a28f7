#include "shared.h"
double from_second(double x) { return x + twice(x); }
