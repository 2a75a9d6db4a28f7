#include "engine/analysis/costs/thread_costs.h"

#include <fmt/format.h>

namespace symreal {

static std::string region(std::string_view name, int threads) {
  std::string text =
      fmt::format("static void {}(void) {{\n#pragma omp parallel sections num_threads({})\n  {{\n", name, threads);
  for (int k = 0; k < threads; ++k) text += fmt::format("#pragma omp section\n    own[{}].value = 1;\n", k);
  return text + "  }\n}\n";
}

// One region per call, as in generated code. The first calls start the threads.
std::string sections_measuring_program() {
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
)" + region("two", 2) +
         region("four", 4) + region("eight", 8) + R"(static int ascending(void const *a, void const *b) {
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
