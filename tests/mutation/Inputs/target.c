#include <math.h>
#include <stdio.h>

static int exponent = 0;

#pragma symreal function input(x) output(return)
double scaled(double x) { return x * frexp(0.75, &exponent); }

int main(void) {
  printf("%g\n", scaled(0.5));
  exponent = 3;
  printf("%g %d\n", scaled(0.5), exponent);
  return 0;
}
