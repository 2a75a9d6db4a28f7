// Crank, rod and slider under a constant moment.
#include "constrained.h"
#include "model.h"

static double const crank = 0.1, rod = 0.3;
static Mechanism<3, 3, 1> const mechanism = {
    {{0.5, 0.002}, {0.8, 0.007}, {1.2, 0.003}},
    {{-1, 0, {0, 0}, {-crank / 2, 0}}, {0, 1, {crank / 2, 0}, {-rod / 2, 0}}, {1, 2, {rod / 2, 0}, {0, 0}}},
    {2, 0},
    2.0,
    0.05,
    50.0};

#pragma symreal function input(state[0 : 18]) output(rate[0 : 18])
void rates(double const *state, double *rate) { mechanism_rates(mechanism, state, rate); }

void initial_state(double *state) {
  double const angle = 0.7, tilt = -std::asin(crank / rod * std::sin(angle));
  double const x = crank * std::cos(angle), y = crank * std::sin(angle);
  double const q[9] = {x / 2, y / 2, angle, x + rod / 2 * std::cos(tilt), y / 2, tilt, x + rod * std::cos(tilt), 0, 0};
  for (int i = 0; i < 18; i++) state[i] = i < 9 ? q[i] : 0;
}

int main() { return print_rates(18); }
