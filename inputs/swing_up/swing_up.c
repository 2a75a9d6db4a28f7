/* A cart swings its pole up in two seconds with the least effort: an optimal-control problem, transcribed by the
   trapezoidal rule into one for a solver of nonlinear programmes. Symreal makes all that the solver asks for of it:
   values, gradient, and the Jacobian and the Hessian of the Lagrangian by what is not zero. */
#include <math.h>
#include <stdio.h>

#ifndef INTERVALS
#define INTERVALS 24
#endif
enum { STATES = 4, POINT = STATES + 1, VARIABLES = (INTERVALS + 1) * POINT, DEFECTS = INTERVALS * STATES };

static double const duration = 2.0;

/* Place of the cart, angle of the pole from hanging down, their rates; and the force on the cart, behind them. */
static void cart_pole(double const *x, double *rate) {
  double const cart = 1.0, pole = 0.3, length = 0.5, gravity = 9.81;
  double const s = sin(x[1]), c = cos(x[1]), force = x[4];
  double const mass = cart + pole * (1.0 - c * c);
  rate[0] = x[2];
  rate[1] = x[3];
  rate[2] = (length * pole * s * x[3] * x[3] + force + pole * gravity * c * s) / mass;
  rate[3] = -(length * pole * c * s * x[3] * x[3] + force * c + (cart + pole) * gravity * s) / (length * mass);
}

/* What the forces cost, and by how much each interval misses the equations of motion. */
#pragma symreal function input(z[0:VARIABLES]) range(-2, 2) output(cost[0:1], defect[0:DEFECTS]) gradient(cost) jacobian(defect, z, sparse) hessian([cost, defect], z, weighted, sparse, symmetric)
void transcribe(double const *z, double *cost, double *defect) {
  double const step = duration / INTERVALS;
  double rate[INTERVALS + 1][STATES];
  for (int k = 0; k <= INTERVALS; k++) cart_pole(z + k * POINT, rate[k]);
  cost[0] = 0.0;
  for (int k = 0; k < INTERVALS; k++) {
    double const *now = z + k * POINT, *next = now + POINT;
    cost[0] += step / 2.0 * (now[STATES] * now[STATES] + next[STATES] * next[STATES]);
    for (int i = 0; i < STATES; i++)
      defect[k * STATES + i] = next[i] - now[i] - step / 2.0 * (rate[k][i] + rate[k + 1][i]);
  }
}

int main(void) {
  double z[VARIABLES], cost[1], defect[DEFECTS];
  for (int k = 0; k < VARIABLES; k++) z[k] = 0.01 * k;
  transcribe(z, cost, defect);
  printf("%.17g\n", cost[0]);
  for (int k = 0; k < DEFECTS; k++) printf("%.17g\n", defect[k]);
  return 0;
}
