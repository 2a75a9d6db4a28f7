/* Times a kernel in three ways, which take turns: on one thread, by two blocks on two threads, and samples shared out
   to two threads. Prints a line a turn: nanoseconds per evaluation in each way. */
#include "crossing.h"
#include "values.h" /* INPUTS, OUTPUTS, VALUES */

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

void compute(double const *input, double const *constants, double *output);

static double values[INPUTS] = {VALUES};
static double one[OUTPUTS], two[OUTPUTS];
/* A thread goes round some samples of its own, which stay in its cache. */
enum { own = 16 };
static _Alignas(64) double samples[2][own][INPUTS], results[2][own][OUTPUTS];
static int calls, rounds;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}
static void bind(int processor) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(processor, &set);
  sched_setaffinity(0, sizeof set, &set);
}
static void evaluate(int thread, int count) {
  for (int k = 0; k < count; ++k) compute(samples[thread][k % own], NULL, results[thread][k % own]);
}

static _Alignas(64) atomic_int started; /* the call or job that may begin */
static _Alignas(64) atomic_int ended;
static void *other(void *unused) {
  (void)unused;
  bind(1);
  for (int round = 0, number = 0; round < rounds; ++round) {
    for (int k = 0; k < calls; ++k) {
      wait_for(&started, ++number);
      block_1(values, two, number);
      atomic_store_explicit(&ended, number, memory_order_release);
    }
    wait_for(&started, ++number);
    evaluate(1, calls / 2);
    atomic_store_explicit(&ended, number, memory_order_release);
  }
  return NULL;
}
int main(int count, char **words) {
  if (count != 3) return 2;
  calls = atoi(words[1]);
  rounds = atoi(words[2]);
  for (int k = 0; k < 2 * own; ++k) memcpy(samples[k / own][k % own], values, sizeof values);
  pthread_t thread;
  bind(0);
  if (pthread_create(&thread, NULL, other, NULL) != 0) return 1;
  for (int round = 0, number = 0; round < rounds; ++round) {
    double const begin = now();
    evaluate(0, calls);
    double const after_one = now();
    for (int k = 0; k < calls; ++k) {
      atomic_store_explicit(&started, ++number, memory_order_release);
      block_0(values, two, number);
      wait_for(&ended, number);
    }
    double const after_blocks = now();
    atomic_store_explicit(&started, ++number, memory_order_release);
    evaluate(0, calls / 2);
    wait_for(&ended, number);
    double const after_batch = now();
    printf("%.2f %.2f %.2f\n", (after_one - begin) / calls, (after_blocks - after_one) / calls,
           (after_batch - after_blocks) / calls);
  }
  pthread_join(thread, NULL);
  compute(values, NULL, one);
  return memcmp(one, two, sizeof one) || memcmp(one, results[0][0], sizeof one) ||
                 memcmp(one, results[1][0], sizeof one)
             ? 3
             : 0;
}
