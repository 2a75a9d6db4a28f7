#include "analysis/costs/thread_costs.h"

namespace symreal {

// As generated code does it: a region for each call. The first ones start the threads.
std::string_view sections_measuring_program() {
  return R"(#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { most = 16, steps = 200 };
static struct { volatile double value, unused[15]; } own[most];

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}
static void two(void) {
#pragma omp parallel sections num_threads(2)
  {
#pragma omp section
    own[0].value = 1;
#pragma omp section
    own[1].value = 1;
  }
}
static void four(void) {
#pragma omp parallel sections num_threads(4)
  {
#pragma omp section
    own[0].value = 1;
#pragma omp section
    own[1].value = 1;
#pragma omp section
    own[2].value = 1;
#pragma omp section
    own[3].value = 1;
  }
}
static void eight(void) {
#pragma omp parallel sections num_threads(8)
  {
#pragma omp section
    own[0].value = 1;
#pragma omp section
    own[1].value = 1;
#pragma omp section
    own[2].value = 1;
#pragma omp section
    own[3].value = 1;
#pragma omp section
    own[4].value = 1;
#pragma omp section
    own[5].value = 1;
#pragma omp section
    own[6].value = 1;
#pragma omp section
    own[7].value = 1;
  }
}
static int ascending(void const *a, void const *b) {
  double const x = *(double const *)a, y = *(double const *)b;
  return (x > y) - (x < y);
}
int main(int count, char **words) {
  int const rounds = count > 1 ? atoi(words[1]) : 1;
  double *const time = malloc(sizeof(double) * (size_t)(rounds < 1 ? 1 : rounds));
  void (*const region[])(void) = {two, four, eight};
  if (rounds < 1 || !time) return 1;
  for (int k = 0, threads = 2; k < 3 && threads <= omp_get_num_procs(); ++k, threads *= 2) {
    for (int round = -1; round < rounds; ++round) {
      double const begin = now();
      for (int step = 0; step < steps; ++step) region[k]();
      if (round >= 0) time[round] = (now() - begin) / steps;
    }
    qsort(time, (size_t)rounds, sizeof *time, ascending);
    printf("%d %.4f\n", threads, time[rounds / 2]);
  }
  return 0;
}
)";
}

} // namespace symreal
