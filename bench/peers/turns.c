/* Contenders in turns, in one process:
     turns KERNEL JOINTS MODEL VECTORS INPUTS OUTPUTS ROUNDS SECONDS SEED CONTENDER.so...
   VECTORS is a file of doubles, 16 input vectors. With ROUNDS 0 it writes the outputs of each contender for all vectors
   to standard output, as doubles. Else it lets the contenders take turns in an order that changes from round to round:
   each warms up for a quarter of a block, then runs a block of about a millisecond of processor time. A round is a line
   of nanoseconds per call, in the order of the command line. After SECONDS no further round begins, but three are done
   in any case. */
#include "contender.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { vectors = 16, most = 256 };

static int inputs, outputs;
static double *input, *output;

static double now(clockid_t clock) {
  struct timespec t;
  clock_gettime(clock, &t);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static double block(Evaluate evaluate, long calls) {
  double const begin = now(CLOCK_THREAD_CPUTIME_ID);
  for (long i = 0; i < calls; i++) evaluate(input + (i % vectors) * inputs, output);
  return (now(CLOCK_THREAD_CPUTIME_ID) - begin) / (double)calls;
}

/* How many calls take a millisecond. */
static long calibrated(Evaluate evaluate) {
  for (long calls = 1;; calls *= 4) {
    double const each = block(evaluate, calls);
    if (each * (double)calls > 5e5) return each > 1e6 ? 1 : (long)(1e6 / each);
  }
}

int main(int argc, char **argv) {
  int const count = argc - 10, rounds = atoi(argv[7]);
  unsigned seed = (unsigned)atoi(argv[9]);
  Evaluate evaluate[most];
  long calls[most];
  double times[most];
  int order[most];
  if (count < 1 || count > most) return 2;
  inputs = atoi(argv[5]);
  outputs = atoi(argv[6]);
  input = malloc(sizeof(double) * vectors * (size_t)inputs);
  output = calloc((size_t)outputs, sizeof(double));
  FILE *file = fopen(argv[4], "rb");
  if (!file || fread(input, sizeof(double) * (size_t)inputs, vectors, file) != vectors) return 3;
  for (int i = 0; i < count; i++) {
    void *object = dlopen(argv[10 + i], RTLD_NOW | RTLD_LOCAL);
    if (!object) return fprintf(stderr, "%s\n", dlerror()), 4;
    Evaluate (*make)(char const *, int, char const *);
    *(void **)&make = dlsym(object, "contender");
    evaluate[i] = make(argv[1], atoi(argv[2]), argv[3]);
    order[i] = i;
  }
  if (rounds == 0) {
    for (int i = 0; i < count; i++)
      for (int k = 0; k < vectors; k++) {
        evaluate[i](input + k * inputs, output);
        fwrite(output, sizeof(double), (size_t)outputs, stdout);
      }
    return 0;
  }
  for (int i = 0; i < count; i++) calls[i] = calibrated(evaluate[i]);
  double const begin = now(CLOCK_MONOTONIC);
  for (int round = 0; round < rounds; round++) {
    if (round >= 3 && now(CLOCK_MONOTONIC) - begin > 1e9 * atof(argv[8])) break;
    for (int i = count - 1; i > 0; i--) {
      seed = seed * 1664525u + 1013904223u;
      int const j = (int)((seed >> 8) % (unsigned)(i + 1)), kept = order[i];
      order[i] = order[j];
      order[j] = kept;
    }
    for (int k = 0; k < count; k++) {
      int const i = order[k];
      block(evaluate[i], (calls[i] + 3) / 4);
      times[i] = block(evaluate[i], calls[i]);
    }
    for (int i = 0; i < count; i++) printf("%.2f ", times[i]);
    printf("\n");
  }
}
