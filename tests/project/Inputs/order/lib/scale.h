#include "config.h"
inline double scaled(double x) { return FACTOR * x; }
