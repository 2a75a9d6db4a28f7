#ifndef SUMMED_H
#define SUMMED_H
#include <scaled.h>
#pragma symreal function input(x) parameter(gain) output(return)
inline double summed(std::vector<double> const &x, double gain) { return gain * gain * x[0] + x[1]; }
#endif
