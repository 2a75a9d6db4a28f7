#ifndef LOSS_H
#define LOSS_H
#pragma symreal function input(x) output(return)
static inline double loss(double x) { return x > 1 ? x * x : x; }
#endif
