/* Van der Pol's oscillator, driven by u, with a loop of explicit Euler steps around the equations of motion. The state and
   its derivative make it a functional mock-up unit: symreal generate oscillator.c --fmu oscillator.fmu */
#include <stdio.h>

#pragma symreal function input(x[0:2], u) parameter(mu) output(dx[0:2], *power) state(x, dx)
static void derivatives(double const x[2], double u, double mu, double dx[2], double *power) {
  dx[0] = x[1];
  dx[1] = mu * (1.0 - x[0] * x[0]) * x[1] - x[0] + u;
  *power = u * x[1];
}

int main(void) {
  double x[2] = {2.0, 0.0}, dx[2], power;
  double const step = 0.0078125, u = 0.25, mu = 1.5;
  int k;
  for (k = 0; k <= 1280; k++) {
    derivatives(x, u, mu, dx, &power);
    if (k % 64 == 0) printf("%.17g %.17g %.17g %.17g\n", k * step, x[0], x[1], power);
    x[0] += step * dx[0];
    x[1] += step * dx[1];
  }
  return 0;
}
