#include <stdio.h>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  double new = 2 * x;
  return new + 1;
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
