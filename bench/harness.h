/* One contender of the benchmark is one process. It reads requests, one a line, from standard input:

     t N    N calls of the kernel, cycling through the input vectors; answers nanoseconds per call
     v      one call with each input vector; answers the outputs in hexadecimal

   so that contenders take turns, in blocks of milliseconds, under the hand of one driver (bench/measure.py). A kernel
   is called in an endless loop, or is a stretch of code that ends with a jump back:

     for (;;) { double *in = bench_next(); kernel(in, bench_parameters, bench_output); }

   bench_next copies an input vector, so that a kernel may write to it: every contender pays for that copy. */
#ifndef BENCH_HARNESS_H
#define BENCH_HARNESS_H

#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { bench_vectors = 16 };

extern double bench_inputs[bench_vectors][BENCH_INPUTS]; /* not const: no compiler may know the values */
extern double bench_parameters[];
extern double bench_output[];
extern double *bench_result; /* where the outputs are after a call: bench_output unless the contender says otherwise */
extern double bench_scratch[BENCH_INPUTS];
extern long bench_left;      /* calls until the request is done */
extern unsigned bench_index; /* of the next input vector */

/* Answers the request that is done, and waits for the next. */
void bench_wait(void);

static inline double *bench_next(void) {
  if (bench_left-- == 0) bench_wait();
  memcpy(bench_scratch, bench_inputs[bench_index++ % bench_vectors], sizeof bench_scratch);
  return bench_scratch;
}

#ifdef __cplusplus
}
#endif

#endif
