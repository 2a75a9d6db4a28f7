#include <math.h>
#include <stdio.h>

double area(double x, double y), length(double x, double y);

#pragma symreal function input(x, y) output(return)
double area(double x, double y) {
#ifdef GUARDED
  if (x < 0) return 0;
#endif
  return x * y;
}

#pragma symreal function input(x, y) output(return)
double length(double x, double y) {
#ifdef GUARDED
  if (y > 10) return 10;
#endif
  return sqrt(x * x + y * y);
}

int main(void) {
  printf("%.17g %.17g %.17g %.17g\n", area(2, 3), length(2, 3), area(-2, 3), length(2, 30));
  return 0;
}
