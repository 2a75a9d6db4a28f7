#pragma once
#include "plain.h"
#include <algorithm>
double from_second(double x);
inline double twice(double x) { return std::max(x, 0.0) + from_second(x); }
