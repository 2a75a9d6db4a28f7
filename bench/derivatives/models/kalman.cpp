// The filter step of inputs/kalman, whose settings are numbers. x: the state; z: its covariance, the measurement; y:
// both updated.
void filter_step(double x[5], double P[5][5], double const z[2], double const settings[8]);

void model(double const *x, double const *z, double *y) {
  double const settings[8] = {0.1, 0.8, 0.3, 0.05, 0.25, 0.02, 20.0, -5.0};
  double state[5], P[5][5];
  for (int i = 0; i < 5; i++) state[i] = x[i];
  for (int i = 0; i < 25; i++) P[i / 5][i % 5] = z[i];
  filter_step(state, P, z + 25, settings);
  for (int i = 0; i < 5; i++) y[i] = state[i];
  for (int i = 0; i < 25; i++) y[5 + i] = P[i / 5][i % 5];
}
