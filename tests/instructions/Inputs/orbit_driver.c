#include <stdio.h>
void orbit(double const x[3], double a[3]);
int main(void) {
  double x[3] = {1, 0.5, 0.2}, a[3];
#pragma symreal input(x) range(0.5, 2)
  orbit(x, a);
#pragma symreal output(a) generate("orbit.c")
  printf("%g\n", a[0]);
}
