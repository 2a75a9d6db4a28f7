// What every simulated model offers: the rates of its state, and where it begins.
#pragma once

#include <cstdio>

void rates(double const *state, double *rate);
void initial_state(double *state);

// The main program of a model: its rates at the beginning.
inline int print_rates(int states) {
  double state[100], rate[100];
  initial_state(state);
  rates(state, rate);
  for (int i = 0; i < states; i++) std::printf("%.17g\n", rate[i]);
  return 0;
}
