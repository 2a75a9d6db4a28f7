// The longitudinal motion of inputs/vehicle with fixed controls: speed, angle of attack, pitch rate, pitch angle,
// altitude.
#include "model.h"

#pragma push_macro("main")
#undef main
#define main vehicle_main
#include "vehicle.cpp"
#pragma pop_macro("main")

#pragma symreal function input(state[0 : 5]) output(rate[0 : 5])
void rates(double const *state, double *rate) { longitudinal(state, 0.4, -0.03, 9300.0, 75000.0, rate); }

void initial_state(double *state) {
  double const start[5] = {150.0, 0.08, 0.01, 0.1, 4000.0};
  for (int i = 0; i < 5; i++) state[i] = start[i];
}

int main() { return print_rates(5); }
