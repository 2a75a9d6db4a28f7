#include "parts.h"

double scale(double x) { return FACTOR * x; }
