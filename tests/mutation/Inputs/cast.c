#include <stdio.h>
#include <stdlib.h>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  double *work = malloc(2 * sizeof *work), y;
  work[0] = x, work[1] = x * x;
  y = work[0] + work[1];
  free(work);
  return y;
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
