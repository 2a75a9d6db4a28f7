// In mode finite the state that generated code leaves may have a zero of another sign than the original's. A call beyond a
// guard that is made with either is the same.
// RUN: %symreal generate %s --decisions=guard -o %t.c && %symreal verify %s %t.c --samples=60 --min-samples=10
#include <math.h>

#pragma symreal function input(s[0:3], u) range(-100.0, 100.0) output(s[0:3])
void kernel(double *s, double u) {
  double const v = atan(u) + s[1] * u * fma(2.0, u, s[2]);
  int const other = v != 10;
  if (-u > 0.3 || other > 1) return;
  s[1] = -6;
  s[0] = 1;
  s[0] = ceil(v) + s[2] - 0.5 * s[0];
  s[1] = v + u;
  s[2] = s[0] + u - v - s[0];
}

int main(void) {
  double s[3] = {1, 2, 3};
  kernel(s, 0.25);
  return s[0] > 100;
}
