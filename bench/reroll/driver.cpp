// Takes turns with the original, straight-line code and loops: driver N MODEL, on standard output the nanoseconds of a
// call, a line a turn. KERNEL is the number of one of those below, STRAIGHT whether there is straight-line code.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <vector>

extern "C" void straight_compute(double const *input, double const *constants, double *output);
extern "C" void reroll_compute(double const *input, double const *constants, double *output);
extern "C" void fast_compute(double const *input, double const *constants, double *output);

static int n;

#if KERNEL < 4
#include "example.h"
static chain::Model *model;
static void original(double const *in, double *out) {
#if KERNEL == 0
  chain::forward_kinematics(*model, in, out);
#elif KERNEL == 1
  chain::inverse_dynamics(*model, in, in + n, in + 2 * n, out);
#elif KERNEL == 2
  chain::forward_dynamics(*model, in, in + n, in + 2 * n, out);
#else
  chain::mass_matrix(*model, in, out);
#endif
}
static void prepare(int argc, char **argv) { model = new chain::Model(chain::example_model(argc, argv)); }
#elif KERNEL == 4
#include "programs/series.cpp"
static std::vector<Term> terms;
static void original(double const *in, double *out) { out[0] = series(terms, in[0]); }
static void prepare(int, char **) { terms = example_terms(n); }
#elif KERNEL == 5
#include "programs/swing.cpp"
static void original(double const *in, double *out) { swing(in, in[2], n, out); }
static void prepare(int, char **) {}
#elif KERNEL == 6
#include "programs/filter.cpp"
static void original(double const *in, double *out) { filter(in, n, out); }
static void prepare(int, char **) {}
#elif KERNEL == 7
#include "programs/covariance.cpp"
static void original(double const *in, double *out) { predict(in, in + n * n, in + 2 * n * n, n, out); }
static void prepare(int, char **) {}
#else
#include "programs/top.cpp"
static void original(double const *in, double *out) { top(in, in + 7, in + 16, in[19], n, out); }
static void prepare(int, char **) {}
#endif

static void straight(double const *in, double *out) {
#if STRAIGHT
  straight_compute(in, nullptr, out);
#else
  (void)in, (void)out;
#endif
}
static void reroll(double const *in, double *out) { reroll_compute(in, nullptr, out); }
static void fast(double const *in, double *out) { fast_compute(in, nullptr, out); }

static bool agree(std::vector<double> const &x, std::vector<double> const &y, double tolerance) {
  for (std::size_t j = 0; j < x.size(); j++)
    if (!(std::fabs(x[j] - y[j]) <= tolerance * std::max(1.0, std::fabs(y[j]))))
      return std::fprintf(stderr, "result %zu differs\n", j), false;
  return true;
}

int main(int argc, char **argv) {
  n = std::atoi(argv[1]);
  prepare(argc, argv);
  int const size = KERNEL == 3 || KERNEL == 7 ? n * n : n;
  std::vector<double> in(3 * size + 3);
  for (std::size_t k = 0; k < in.size(); k++) in[k] = 0.3 + 0.001 * (k % 700);
#if KERNEL == 8
  std::copy_n(example, std::size(example), in.begin());
#endif
  void (*const contenders[])(double const *, double *) = {original, straight, reroll, fast};
  std::vector<double> results[4];
  for (int k = 0; k < 4; k++) {
    results[k].resize(size + 12);
    contenders[k](in.data(), results[k].data());
  }
  // The original is fused as gcc likes it: near, but not equal.
  if (!agree(results[2], results[0], 1e-6) || !agree(results[3], results[0], 1e-6)) return 1;
  if (STRAIGHT && !agree(results[1], results[2], 0)) return 1;
  std::vector<double> out(size + 12);
  double turn = 2e6; // nanoseconds
  for (int round = 0; round < 41; round++) {
    for (int k = 0; k < 4; k++) {
      long calls = 0;
      auto const start = std::chrono::steady_clock::now();
      double time = 0;
      for (; time < turn; calls++) {
        in[0] += 1e-9;
        contenders[k](in.data(), out.data());
        if (calls % 8 == 7 || n > 100)
          time = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
      }
      std::printf("%g ", time / calls);
    }
    std::printf("\n");
  }
}
