/* The generated code as a contender: preprocess once, compute in the loop. */
#include "harness.h"

#include BENCH_HEADER

int main(void) {
  static double constants[constant_count + 1];
  preprocess(bench_parameters, constants);
  for (;;) compute(bench_next(), constants, bench_output);
}
