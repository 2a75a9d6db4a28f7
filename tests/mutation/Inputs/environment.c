#include <fenv.h>
#include <stdio.h>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  double y;
  feclearexcept(FE_ALL_EXCEPT);
  y = 1 / x;
  return fetestexcept(FE_INEXACT) ? 2 * x : y;
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
