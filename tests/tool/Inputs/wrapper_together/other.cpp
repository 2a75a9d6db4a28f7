#include "summed.h"

double other(double x) { return summed({x, x}, 2) + scaled({x, 1}); }
