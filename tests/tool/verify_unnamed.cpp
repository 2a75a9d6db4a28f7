// State that a recording misses shows when the original runs on other bytes in what no clause names: verify watches what
// its kernel meets in memory, and changes that. Bytes that are read without effect on the outputs are not reported, nor is
// what never changes, or what the clauses need to name numbers.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: cd %t && %symreal generate %s -o ./ -- -std=c++20
// RUN: cd %t && not %symreal verify %s reference.c bits.c heap.c range.c printed.c locked.c never_changed.c made_at_start.c constant.c made_here.c --samples=20 --min-samples=5 -- -std=c++20 2>&1 | FileCheck %s --implicit-check-not=error:
// CHECK-DAG: error: kernel 'reference': the outputs of the original depend on 'referred::gain' ({{.*}}verify_unnamed.cpp:{{[0-9:]+}}), which no clause names [SYM017]
// CHECK-DAG: error: kernel 'bits': the outputs of the original depend on 'limits' ({{.*}}), which no clause names [SYM017]
// CHECK-DAG: error: kernel 'heap': the outputs of the original depend on a block of 4 bytes on the heap ({{.*}}), which no clause names [SYM017]
// CHECK-DAG: error: kernel 'range': the original overwrites 'cells' ({{.*}}) with the bytes that it holds [SYM121]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace referred {
struct Law {
  double &of;
};
static double gain = 2;
void change(double to) { gain = to; }
} // namespace referred
#pragma symreal function input(x) output(return)
double reference(double x) {
  auto [of] = referred::Law{referred::gain};
  return of * x;
}

struct Limits {
  unsigned order : 3, sign : 1;
};
static Limits limits{2, 1};
void change_limits(int to) { limits.order = to & 7; }
#pragma symreal function input(x) output(return)
double bits(double x) { return limits.order * x; }

struct Settings {
  int *order = new int(2);
  int *find() const { return order; }
};
static Settings *settings = new Settings;
void change_settings(int to) { *settings->order = to; }
#pragma symreal function input(x) output(return)
double heap(double x) { return x * __atomic_load_n(settings->find(), __ATOMIC_RELAXED); }

static int cells[2] = {1, 2};
static int const made[2] = {1, 2};
int first_cell() { return ++cells[0]; }
#pragma symreal function input(x) output(return)
double range(double x) {
  std::ranges::copy(made, cells);
  return 2 * x;
}

struct Told {
  unsigned often : 3, late : 1;
};
static Told told{1, 0};
void tell(int often) { told.often = often & 7; }
#pragma symreal function input(x) output(return)
double printed(double x) {
  if (told.often > 0) std::puts("called");
  return 2 * x;
}

struct Guarded {
  std::mutex mutex;
  std::shared_ptr<int> order = std::make_shared<int>(2);
};
static Guarded *const guarded = new Guarded;
static std::mutex other;
#pragma symreal function input(x) output(return)
double locked(double x) {
  std::scoped_lock const lock(guarded->mutex, other);
  std::shared_ptr<int> const copy = guarded->order;
  return 2 * x;
}

static int order = 2;
static double const table[2] = {std::sqrt(2), std::sqrt(3)};
static std::vector<double> const more = {1, 2, 3};
#pragma symreal function input(x) output(return)
double never_changed(double x) { return x * order + table[1] * more[2]; }

static std::map<std::string, double> const gains = {{"slow", 1}, {"fast", 2}};
#pragma symreal function input(x) output(return)
double made_at_start(double x) { return x * gains.at("fast"); }

static int const count = 3;
#pragma symreal function input(x) output(return)
double constant(double x) {
  static std::vector<double> const powers(count, 2.0);
  double sum = 0;
  for (double one : powers) sum += one * x;
  return sum;
}

#pragma symreal function input(x) output(return)
double made_here(double x) {
  auto numbers = std::make_unique<std::vector<double>>(3, x);
  std::sort(numbers->begin(), numbers->end());
  std::map<int, double> sums;
  for (int k = 0; k < 3; ++k) sums[k] += (*numbers)[k];
  return sums[1];
}

int main() {
  double sum = 0;
  for (double (*kernel)(double) : {reference, bits, heap, range, printed, locked, never_changed, made_at_start, constant, made_here})
    sum += kernel(0.5);
  return sum > 1000;
}
