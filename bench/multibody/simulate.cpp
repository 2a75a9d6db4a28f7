// A model integrated by the classical Runge-Kutta method of order four. -DSTATES -DSTEPS -DSTEP=seconds, and for
// generated code -DBENCH_HEADER="file".
//
//   simulate        nanoseconds per step
//   simulate N      the state in hexadecimal, every N steps and at the end
#include "model.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>

#ifdef BENCH_HEADER
#include BENCH_HEADER
static double constants[constant_count + 1];
static void derivative(double const *state, double *rate) { compute(state, constants, rate); }
static void prepare() { preprocess(nullptr, constants); }
#else
static void derivative(double const *state, double *rate) { rates(state, rate); }
static void prepare() {}
#endif

static void step(double *state, double h) {
  double k[4][STATES], moved[STATES];
  double const reach[4] = {0, h / 2, h / 2, h};
  for (int stage = 0; stage < 4; stage++) {
    for (int i = 0; i < STATES; i++) moved[i] = stage == 0 ? state[i] : state[i] + reach[stage] * k[stage - 1][i];
    derivative(moved, k[stage]);
  }
  for (int i = 0; i < STATES; i++) state[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
}

static void print(double const *state) {
  for (int i = 0; i < STATES; i++) std::printf("%a%c", state[i], i + 1 < STATES ? ' ' : '\n');
}

static double now() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e9 + static_cast<double>(t.tv_nsec);
}

int main(int argc, char **argv) {
  double state[STATES];
  int const every = argc > 1 ? std::atoi(argv[1]) : 0;
  prepare();
  initial_state(state);
  double const begin = now();
  for (int i = 0; i < STEPS; i++) {
    if (every > 0 && i % every == 0) print(state);
    step(state, STEP);
  }
  double const taken = now() - begin;
  if (every > 0)
    print(state);
  else
    std::printf("%.3f\n", taken / STEPS);
}
