/* Times code for one thread and code whose threads share an evaluation, in turns: one_compute and all_compute. Prints a
   line a turn: nanoseconds per evaluation of both. Status 3: their numbers differ. */
#include "values.h" /* INPUTS, OUTPUTS, VALUES */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

void one_compute(double const *input, double const *constants, double *output);
void all_compute(double const *input, double const *constants, double *output);

static double values[INPUTS] = {VALUES};
static double one[OUTPUTS], all[OUTPUTS];

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}
int main(int count, char **words) {
  if (count != 3) return 2;
  int const calls = atoi(words[1]), rounds = atoi(words[2]);
  for (int round = -1; round < rounds; ++round) { /* the first one starts the threads */
    double const begin = now();
    for (int k = 0; k < calls; ++k) one_compute(values, NULL, one);
    double const after_one = now();
    for (int k = 0; k < calls; ++k) all_compute(values, NULL, all);
    double const after_all = now();
    if (round >= 0) printf("%.2f %.2f\n", (after_one - begin) / calls, (after_all - after_one) / calls);
  }
  return memcmp(one, all, sizeof one) ? 3 : 0;
}
