/* A damped oscillation, seen at twenty times: what a fit of its amplitude, damping, frequency, phase and offset makes
   small. */
#include <math.h>
#include <stdio.h>

enum { TIMES = 20 };

#pragma symreal function input(p[0:5]) range(0.1, 2) parameter(seen[0:TIMES]) output(residual[0:TIMES]) jacobian(residual, p)
void residuals(double const p[5], double const seen[TIMES], double residual[TIMES]) {
  for (int k = 0; k < TIMES; k++) {
    double const t = 0.25 * k;
    residual[k] = p[0] * exp(-p[1] * t) * cos(p[2] * t + p[3]) + p[4] - seen[k];
  }
}

int main(void) {
  double const p[5] = {1.2, 0.3, 1.9, 0.4, 0.1};
  double seen[TIMES] = {0.0}, residual[TIMES];
  residuals(p, seen, residual);
  for (int k = 0; k < TIMES; k++) printf("%.17g\n", residual[k]);
  return 0;
}
