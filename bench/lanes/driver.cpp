// Takes turns with the original, scalar code and vectors: on standard output the nanoseconds of a call, a line a turn.
// ORIGINAL(in, out) calls the original with the arrays of the generated functions.
#include <chrono>
#include <cmath>
#include <cstdio>

extern "C" void scalar_compute(double const *input, double const *constants, double *output);
extern "C" void vector_compute(double const *input, double const *constants, double *output);

#if KERNEL < 2
extern "C" void hourglass_force(double const (*x)[8], double const (*v)[8], double damping, double (*force)[8]);
extern "C" void deformation_rate(double const (*x)[8], double const (*v)[8], double *rate);
static void original(double const *in, double *out) {
  auto const x = reinterpret_cast<double const(*)[8]>(in), v = reinterpret_cast<double const(*)[8]>(in + 24);
#if KERNEL == 0
  hourglass_force(x, v, in[48], reinterpret_cast<double(*)[8]>(out));
#else
  deformation_rate(x, v, out);
#endif
}
#else
#include "example.h"
static chain::Model const model = chain::example_model(1, nullptr);
static void original(double const *in, double *out) {
#if KERNEL == 2
  chain::inverse_dynamics(model, in, in + 6, in + 12, out);
#else
  chain::forward_dynamics(model, in, in + 6, in + 12, out);
#endif
}
#endif

static void scalar(double const *in, double *out) { scalar_compute(in, nullptr, out); }
static void vector(double const *in, double *out) { vector_compute(in, nullptr, out); }

// Several inputs, as a program has that calls the function for one element after the other.
enum { inputs = 16 };
alignas(64) static double in[inputs][64];
alignas(64) static double out[3][inputs][32];

int main() {
  for (int k = 0; k < inputs; k++)
    for (int j = 0; j < 64; j++) {
      in[k][j] = std::sin(1 + 64 * k + j);
#if KERNEL < 2 // an element that is nearly a cube
      int const node = j % 8, corner = j < 8 ? ((node + 1) / 2) % 2 : j < 16 ? (node / 2) % 2 : node / 4;
      if (j < 24) in[k][j] = corner + 0.1 * in[k][j];
#endif
    }
  void (*const contenders[])(double const *, double *) = {original, scalar, vector};
  for (int c = 0; c < 3; c++)
    for (int k = 0; k < inputs; k++) contenders[c](in[k], out[c][k]);
  for (int k = 0; k < inputs; k++)
    for (int j = 0; j < 32; j++) { // the original is fused as its compiler likes it: near, but not equal
      if (out[1][k][j] != out[2][k][j]) return std::fprintf(stderr, "result %d of vectors differs\n", j), 1;
      bool const is_near = std::fabs(out[0][k][j] - out[1][k][j]) <= 1e-6 * std::fmax(1, std::fabs(out[1][k][j]));
      if (!is_near) return std::fprintf(stderr, "result %d of the original differs\n", j), 1;
    }
  for (int turn = 0; turn < 41; turn++) {
    for (int c = 0; c < 3; c++) {
      int rounds = 0;
      double time = 0;
      auto const start = std::chrono::steady_clock::now();
      for (; time < 1e6; rounds += 8) {
        for (int r = 0; r < 8; r++)
          for (int k = 0; k < inputs; k++) contenders[c](in[k], out[c][k]);
        time = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
      }
      std::printf("%g ", time / rounds / inputs);
    }
    std::printf("\n");
  }
}
