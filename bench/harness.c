#include "harness.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* The file that BENCH_DATA names defines BENCH_INPUT_VALUES and BENCH_PARAMETER_VALUES. */
#include BENCH_DATA

double bench_inputs[bench_vectors][BENCH_INPUTS] = BENCH_INPUT_VALUES;
double bench_parameters[] = BENCH_PARAMETER_VALUES;
double bench_output[BENCH_OUTPUTS];
double *bench_result = bench_output;
double bench_scratch[BENCH_INPUTS];
long bench_left = 0;
unsigned bench_index = 0;

static double start;
static long calls = 0, values = 0;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t); /* what other processes take is not ours */
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

void bench_wait(void) {
  double end = now();
  char line[64];
  if (calls > 0) {
    printf("%.6f\n", (end - start) / (double)calls);
    fflush(stdout);
  }
  if (values > 0) {
    for (int i = 0; i < BENCH_OUTPUTS; i++) printf("%a ", bench_result[i]);
    if (--values > 0) {
      bench_left = 0; /* this call is the one that is left */
      return;
    }
    printf("\n");
    fflush(stdout);
  }
  if (!fgets(line, sizeof line, stdin)) exit(0);
  calls = line[0] == 't' ? atol(line + 1) : 0;
  values = line[0] == 'v' ? bench_vectors : 0;
  bench_left = calls > 0 ? calls - 1 : 0;
  bench_index = 0;
  start = now();
}
