#include "shared.h"
double two(double x) { return x * gravity; }
