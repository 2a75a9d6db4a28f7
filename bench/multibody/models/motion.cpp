// A tree of bodies whose joints have springs and dampers: angles, then their rates. -DSHAPE="name" -DN=bodies
#include "model.h"
#include "tree.h"

static tree::Tree const bodies = tree::make_tree(SHAPE, N);

#pragma symreal function input(state[0 : 2 * N]) constant(bodies) output(rate[0 : 2 * N])
void rates(double const *state, double *rate) {
  double tau[N];
  for (int i = 0; i < N; i++) {
    tau[i] = -20.0 * state[i] - 4.0 * state[N + i];
    rate[i] = state[N + i];
  }
  forward_dynamics(bodies, state, state + N, tau, rate + N);
}

void initial_state(double *state) {
  for (int i = 0; i < N; i++) {
    state[i] = 0.3 - 0.1 * (i % 4);
    state[N + i] = 0;
  }
}

int main() { return print_rates(2 * N); }
