#include <math.h>
#include <stdio.h>

static double const table[N] = {1, 2, 3, 4, 5, 6};

#pragma symreal function input(x[0:N]) range(-2, 2) output(y[0:T]) decisions(select)
void mix(double const *x, double *y) {
  for (int i = 0; i < T; ++i) {
    y[i] = sin(x[i]) * table[i] + value * x[N - 1];
    if (y[i] > T) y[i] = T;
  }
}

int main(void) {
  double x[N] = {0.5, 1, 1.5, 2, -1, -0.5}, y[T];
  mix(x, y);
  printf("%.9g\n", y[0]);
  return 0;
}
