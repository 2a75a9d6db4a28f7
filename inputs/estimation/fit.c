/* Levenberg and Marquardt's fit, with a Jacobian that nobody has written: symreal generate fit_model.c -o fit_code.c has
   made what is called here. */
#include "fit_code.h"

#include <math.h>
#include <stdio.h>

enum { UNKNOWNS = input_count, RESIDUALS = parameter_count };

static double half_square(double const *residual) {
  double sum = 0.0;
  for (int k = 0; k < RESIDUALS; k++) sum += residual[k] * residual[k] / 2.0;
  return sum;
}

/* By elimination: the matrix is positive definite. */
static void solve(double a[UNKNOWNS][UNKNOWNS], double x[UNKNOWNS]) {
  for (int i = 0; i < UNKNOWNS; i++)
    for (int j = i + 1; j < UNKNOWNS; j++) {
      double const factor = a[j][i] / a[i][i];
      for (int k = i; k < UNKNOWNS; k++) a[j][k] -= factor * a[i][k];
      x[j] -= factor * x[i];
    }
  for (int i = UNKNOWNS; i-- > 0;) {
    for (int k = i + 1; k < UNKNOWNS; k++) x[i] -= a[i][k] * x[k];
    x[i] /= a[i][i];
  }
}

/* One step: (J'J + damping diag J'J) step = -J'r. */
static void step_from(output_values const *at, double damping, double step[UNKNOWNS]) {
  double a[UNKNOWNS][UNKNOWNS] = {{0.0}};
  for (int i = 0; i < UNKNOWNS; i++) {
    step[i] = 0.0;
    for (int k = 0; k < RESIDUALS; k++) {
      step[i] -= at->jacobian_residual_p[k][i] * at->residual[k];
      for (int j = 0; j < UNKNOWNS; j++) a[i][j] += at->jacobian_residual_p[k][i] * at->jacobian_residual_p[k][j];
    }
    a[i][i] *= 1.0 + damping;
  }
  solve(a, step);
}

int main(void) {
  double const truth[UNKNOWNS] = {1.2, 0.3, 1.9, 0.4, 0.1};
  double seen[RESIDUALS] = {0.0}, constants[constant_count];
  output_values now, next;
  preprocess(seen, constants);
  compute(truth, constants, (double *)&now);
  for (int k = 0; k < RESIDUALS; k++) seen[k] = now.residual[k];
  preprocess(seen, constants);

  double p[UNKNOWNS] = {1.0, 0.5, 1.6, 0.1, 0.0}, damping = 1e-3;
  compute(p, constants, (double *)&now);
  int steps = 0;
  for (; steps < 50 && half_square(now.residual) > 1e-28; steps++) {
    double step[UNKNOWNS], trial[UNKNOWNS];
    step_from(&now, damping, step);
    for (int i = 0; i < UNKNOWNS; i++) trial[i] = p[i] + step[i];
    compute(trial, constants, (double *)&next);
    if (half_square(next.residual) < half_square(now.residual)) {
      for (int i = 0; i < UNKNOWNS; i++) p[i] = trial[i];
      now = next;
      damping /= 10.0;
    } else {
      damping *= 10.0;
    }
  }
  for (int i = 0; i < UNKNOWNS; i++) printf("%.9f\n", p[i]);
  printf("%s\n", steps <= 10 ? "at most 10 steps" : "more than 10 steps");
  return 0;
}
