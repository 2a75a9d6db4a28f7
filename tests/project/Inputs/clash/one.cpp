#define AS_CONSTANT
#include "shared.h"
double one(double x) { return x * gravity; }
