#include <math.h>
#include <stdio.h>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  float const third = 1.0f / 3;
  return x * sqrt(third);
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
