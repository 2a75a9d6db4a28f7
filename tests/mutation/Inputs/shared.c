#include <stdio.h>
#define PUT(target) target = x * 2
#pragma symreal function input(x) range(5.1, 5.4) output(return)
double kernel(double x) {
  int i;
  double y;
  PUT(i);
  PUT(y);
  return y + i;
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
