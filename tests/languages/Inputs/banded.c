#include <math.h>
#include <stdio.h>

#ifndef ROWS
#define ROWS 3
#endif

int main(void) {
  double x[ROWS + 1] = {0.5, 1.25}, y[ROWS];
#pragma symreal input(x[0:ROWS + 1]) range(-2, 2)
  for (int i = 0; i < ROWS; i++) y[i] = x[i] * x[i + 1];
#pragma symreal output(y[0:ROWS]) generate("banded.c")
  printf("%g\n", y[0]);
  return 0;
}
