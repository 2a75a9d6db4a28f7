#define BASE float
#include "third.h"
double single(double x) { return third(x); }
