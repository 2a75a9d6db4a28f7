#include "a.h"
static int calls;
static double limit(double x, double most) { if (x > most) { calls++; x = most; } return x; }
static double back(double *held, double x) { double y = *held; *held = x; return y; }
double filtered(double x) {
  static double last = 0;
  last = back(&last, limit(x, 3.0));
  return last;
}
