#include <cmath>

double half = 1.0 / 2.0;
double root = std::sqrt(2.0);
double table[2] = {3.0, -4.0};
