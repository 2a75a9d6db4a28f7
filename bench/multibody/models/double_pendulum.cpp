// Two point masses on massless rods: angles from the vertical, then their rates.
#include "model.h"

#include <cmath>

#pragma symreal function input(state[0 : 4]) output(rate[0 : 4])
void rates(double const *state, double *rate) {
  double const m1 = 1.0, m2 = 0.7, l1 = 1.0, l2 = 0.8, g = 9.81;
  double const a = state[0], b = state[1], u = state[2], w = state[3];
  double const c = std::cos(a - b), s = std::sin(a - b);
  double const share = m1 + m2 * s * s;
  double const pull = m2 * (l1 * u * u * c + l2 * w * w) * s;
  rate[0] = u;
  rate[1] = w;
  rate[2] = -(pull + (m1 + m2) * g * std::sin(a) - m2 * g * std::sin(b) * c) / (l1 * share);
  rate[3] =
      ((m1 + m2) * (l1 * u * u * s + g * std::sin(a) * c - g * std::sin(b)) + m2 * l2 * w * w * s * c) / (l2 * share);
}

void initial_state(double *state) {
  state[0] = 2.0;
  state[1] = 1.5;
  state[2] = state[3] = 0.0;
}

int main() { return print_rates(4); }
