#include "a/header/of/another/machine.h"

double power(double x, double v) { return x * v; }
