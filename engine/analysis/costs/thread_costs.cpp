#include "engine/analysis/costs/thread_costs.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace symreal {

namespace {

double rounded(double nanoseconds) { return std::round(nanoseconds * 10) / 10; }

double time_of(nlohmann::json const &json, char const *which) {
  double const value = json.at(which).get<double>();
  if (!(value > 0 && value <= 1e9))
    throw std::out_of_range(fmt::format("'{}' is {}, which is not a time", which, value));
  return value;
}

unsigned count_of(nlohmann::json const &json, char const *which) {
  long const value = json.at(which).get<long>();
  if (value < 1 || value > 1L << 20)
    throw std::out_of_range(fmt::format("'{}' is {}, which is not a number of them", which, value));
  return static_cast<unsigned>(value);
}

double of(std::vector<ThreadCosts::Barrier> const &all, unsigned threads) {
  for (ThreadCosts::Barrier const &one : all)
    if (one.threads >= threads) return one.nanoseconds;
  return all.back().nanoseconds;
}

std::string region(std::string_view name, int threads) {
  std::string text =
      fmt::format("static void {}(void) {{\n#pragma omp parallel sections num_threads({})\n  {{\n", name, threads);
  for (int k = 0; k < threads; ++k) text += fmt::format("#pragma omp section\n    own[{}].value = 1;\n", k);
  return text + "  }\n}\n";
}

} // namespace

double ThreadCosts::barrier(unsigned threads) const { return of(barriers, threads); }
double ThreadCosts::sections_for(unsigned threads) const { return of(sections, threads); }

std::vector<ThreadCosts::Barrier> measured_sections(std::string_view output) {
  std::vector<ThreadCosts::Barrier> result;
  std::istringstream lines{std::string(output)};
  for (ThreadCosts::Barrier one{}; lines >> one.threads >> one.nanoseconds;)
    result.push_back({one.threads, rounded(one.nanoseconds)});
  return lines.eof() ? result : std::vector<ThreadCosts::Barrier>();
}

std::optional<ThreadCosts> measured_thread_costs(std::string_view output) {
  ThreadCosts costs;
  unsigned threads = 0, known = 0;
  double time = 0;
  std::istringstream lines{std::string(output)};
  for (std::string name; lines >> name; ++known) {
    if (name == "processors")
      lines >> costs.processors >> costs.cores;
    else if (name == "hand_over")
      lines >> costs.hand_over;
    else if (name == "wake")
      lines >> costs.wake;
    else if (name == "start")
      lines >> costs.start;
    else if (name == "barrier" && lines >> threads >> time)
      costs.barriers.push_back({threads, rounded(time)});
    else
      return {};
    if (!lines) return {};
  }
  for (double *one : {&costs.hand_over, &costs.wake, &costs.start}) *one = rounded(*one);
  bool const is_alone = costs.processors == 1 && known == 1;
  bool const is_all =
      costs.processors > 1 && costs.is_measured() && costs.hand_over > 0 && costs.wake > 0 && costs.start > 0;
  return is_alone || is_all ? std::optional(costs) : std::nullopt;
}

nlohmann::ordered_json to_json(ThreadCosts const &costs) {
  nlohmann::ordered_json json = {{"processors", costs.processors}, {"cores", costs.cores}};
  if (!costs.is_measured()) return json;
  json["hand_over"] = costs.hand_over;
  json["wake"] = costs.wake;
  json["start"] = costs.start;
  for (ThreadCosts::Barrier const &one : costs.barriers)
    json["barriers"].push_back({{"threads", one.threads}, {"nanoseconds", one.nanoseconds}});
  for (ThreadCosts::Barrier const &one : costs.sections)
    json["sections"].push_back({{"threads", one.threads}, {"nanoseconds", one.nanoseconds}});
  return json;
}

ThreadCosts thread_costs(nlohmann::json const &json) {
  ThreadCosts costs{count_of(json, "processors"), count_of(json, "cores")};
  if (!json.contains("barriers")) return costs;
  costs.hand_over = time_of(json, "hand_over");
  costs.wake = time_of(json, "wake");
  costs.start = time_of(json, "start");
  for (nlohmann::json const &one : json.at("barriers"))
    costs.barriers.push_back({count_of(one, "threads"), time_of(one, "nanoseconds")});
  if (json.contains("sections"))
    for (nlohmann::json const &one : json.at("sections"))
      costs.sections.push_back({count_of(one, "threads"), time_of(one, "nanoseconds")});
  if (costs.barriers.empty()) throw std::out_of_range("'barriers' is empty");
  return costs;
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

std::string_view thread_measuring_program() {
  return R"(#define _GNU_SOURCE
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { most = 16, steps = 200 };
static int processor[CPU_SETSIZE], processors, cores;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}
static int is_first_of_its_core(int one) {
  char path[128];
  snprintf(path, sizeof path, "/sys/devices/system/cpu/cpu%d/topology/thread_siblings_list", one);
  FILE *const file = fopen(path, "r");
  int first = one;
  if (file && fscanf(file, "%d", &first) != 1) first = one;
  if (file) fclose(file);
  return first == one;
}
/* Those of different cores first. */
static void find_processors(void) {
  cpu_set_t all;
  if (sched_getaffinity(0, sizeof all, &all) != 0) exit(1);
  for (int first = 1; first >= 0; --first) {
    for (int k = 0; k < CPU_SETSIZE; ++k)
      if (CPU_ISSET(k, &all) && is_first_of_its_core(k) == first) processor[processors++] = k;
    if (first) cores = processors;
  }
  if (cores == 0) cores = 1;
}
static void bind(int thread) {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(processor[thread], &one);
  sched_setaffinity(0, sizeof one, &one);
}
/* Who waits for a thread that another process keeps from running lets it run. */
static void relax(int *spins) {
#if defined __x86_64__ || defined __i386__
  __builtin_ia32_pause();
#endif
  if (++*spins == 20000) *spins = 0, sched_yield();
}

static struct { _Alignas(128) atomic_int value; } ball, arrived, phase;
static void wait_for(atomic_int *number, int value) {
  for (int spins = 0; atomic_load_explicit(number, memory_order_acquire) != value;) relax(&spins);
}
static void barrier(int threads) {
  int const now_in = atomic_load_explicit(&phase.value, memory_order_relaxed);
  if (atomic_fetch_add(&arrived.value, 1) == threads - 1) {
    atomic_store_explicit(&arrived.value, 0, memory_order_relaxed);
    atomic_store_explicit(&phase.value, now_in + 1, memory_order_release);
  } else {
    wait_for(&phase.value, now_in + 1);
  }
}

static int threads_now, rounds;
static void *in_barriers(void *number) {
  bind((int)(size_t)number);
  for (int k = 0; k < rounds * (steps + 1); ++k) barrier(threads_now);
  return NULL;
}
static void *gives_back(void *unused) {
  (void)unused;
  bind(1);
  for (int k = 0; k < rounds * steps; ++k) {
    wait_for(&ball.value, 2 * k + 1);
    atomic_store_explicit(&ball.value, 2 * k + 2, memory_order_release);
  }
  return NULL;
}
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static int jobs, done;
static void change(int *which) {
  pthread_mutex_lock(&lock);
  ++*which;
  pthread_cond_broadcast(&changed);
  pthread_mutex_unlock(&lock);
}
static void sleep_until(int *which, int value) {
  pthread_mutex_lock(&lock);
  while (*which != value) pthread_cond_wait(&changed, &lock);
  pthread_mutex_unlock(&lock);
}
static void *sleeps(void *unused) {
  (void)unused;
  bind(1);
  for (int k = 0; k < rounds; ++k) {
    sleep_until(&jobs, k + 1);
    change(&done);
  }
  return NULL;
}
static void *nothing(void *unused) { return unused; }

static int ascending(void const *a, void const *b) {
  double const x = *(double const *)a, y = *(double const *)b;
  return (x > y) - (x < y);
}
static double median(double *time) {
  qsort(time, (size_t)rounds, sizeof *time, ascending);
  return time[rounds / 2];
}
static void start(pthread_t *thread, void *(*run)(void *), int number) {
  if (pthread_create(thread, NULL, run, (void *)(size_t)number) != 0) exit(1);
}
int main(int count, char **words) {
  rounds = count > 1 ? atoi(words[1]) : 1;
  double *const time = malloc(sizeof(double) * (size_t)rounds);
  if (rounds < 1 || !time) return 1;
  find_processors();
  printf("processors %d %d\n", processors, cores);
  if (processors < 2) return 0;
  pthread_t other[most];
  bind(0);
  start(&other[0], gives_back, 1);
  for (int round = 0, k = 0; round < rounds; ++round) {
    double const begin = now();
    for (int end = k + steps; k < end; ++k) {
      atomic_store_explicit(&ball.value, 2 * k + 1, memory_order_release);
      wait_for(&ball.value, 2 * k + 2);
    }
    time[round] = (now() - begin) / steps / 2;
  }
  pthread_join(other[0], NULL);
  printf("hand_over %.4f\n", median(time));
  for (threads_now = 2; threads_now <= processors && threads_now <= most; threads_now *= 2) {
    for (int k = 1; k < threads_now; ++k) start(&other[k], in_barriers, k);
    for (int round = 0; round < rounds; ++round) {
      barrier(threads_now);
      double const begin = now();
      for (int k = 0; k < steps; ++k) barrier(threads_now);
      time[round] = (now() - begin) / steps;
    }
    for (int k = 1; k < threads_now; ++k) pthread_join(other[k], NULL);
    printf("barrier %d %.4f\n", threads_now, median(time));
  }
  start(&other[0], sleeps, 1);
  for (int round = 0; round < rounds; ++round) {
    struct timespec const pause = {0, 100000};
    nanosleep(&pause, NULL); /* so that it sleeps */
    double const begin = now();
    change(&jobs);
    sleep_until(&done, round + 1);
    time[round] = now() - begin;
  }
  pthread_join(other[0], NULL);
  printf("wake %.4f\n", median(time));
  for (int round = 0; round < rounds; ++round) {
    double const begin = now();
    start(&other[0], nothing, 0);
    pthread_join(other[0], NULL);
    time[round] = now() - begin;
  }
  printf("start %.4f\n", median(time));
  return 0;
}
)";
}

} // namespace symreal
