#define BASE double
#include "third.h"
double plain(double x) { return third(x); }
