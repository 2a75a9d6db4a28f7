#include "@BASE@.h"

#include <stdio.h>
#include <time.h>

static double values[@INPUTS@ + @PARAMETERS@ + 1], constants[@CONSTANTS@ + 1], output[@OUTPUTS@ + 1];

int main(void) {
  FILE *file = fopen("values", "r");
  long calls;
  for (int i = 0; fscanf(file, "%lf", &values[i]) == 1; ++i) {}
  double const first = values[0];
  preprocess(values + @INPUTS@, constants);
  while (scanf("%ld", &calls) == 1) {
    struct timespec begin, end;
    double sum = 0.0;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    for (long i = 0; i < calls; ++i) {
      values[0] = first + 1e-7 * (double)(i & 15);
      compute(values, constants, output);
      sum += output[0];
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    printf("%.17g %.17g\n", ((double)(end.tv_sec - begin.tv_sec) * 1e9 + (double)(end.tv_nsec - begin.tv_nsec)) / (double)calls, sum);
    fflush(stdout);
  }
}
