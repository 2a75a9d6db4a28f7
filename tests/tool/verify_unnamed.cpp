// State that a recording misses shows when the original runs on other bytes in what no clause names: verify watches what
// its kernel meets in memory, and changes that.
// DEFINE: %{of} =
// DEFINE: %{generate} = %symreal generate %s --kernel 'kern(x=0.5) -> return' -o %t.c -- -std=c++20 -D%{of}
// DEFINE: %{verify} = %symreal verify %s --kernel 'kern(x=0.5) -> return' %t.c --samples=20 --min-samples=5 -- -std=c++20 -D%{of}
// DEFINE: %{finds} = %{generate} && not %{verify} 2>&1 | FileCheck %s --check-prefix=%{of}
// DEFINE: %{passes} = %{generate} && %{verify}
// REDEFINE: %{of} = REFERENCE
// RUN: %{finds}
// REFERENCE: error: kernel 'kern': the outputs of the original depend on 'gain' ({{.*}}verify_unnamed.cpp:{{[0-9:]+}}), which no clause names [SYM017]
// REDEFINE: %{of} = BITS
// RUN: %{finds}
// BITS: error: kernel 'kern': the outputs of the original depend on 'limits' ({{.*}}), which no clause names [SYM017]
// REDEFINE: %{of} = HEAP
// RUN: %{finds}
// HEAP: error: kernel 'kern': the outputs of the original depend on a block of 4 bytes on the heap ({{.*}}), which no clause names [SYM017]
// REDEFINE: %{of} = RANGE
// RUN: %{finds}
// RANGE: error: kernel 'kern': the original overwrites 'cells' ({{.*}}) with the bytes that it holds [SYM121]

// Bytes that are read without effect on the outputs are not reported, nor is what never changes, or what the clauses need
// to name numbers.
// REDEFINE: %{of} = PRINTED
// RUN: %{passes}
// REDEFINE: %{of} = LOCKED
// RUN: %{passes}
// REDEFINE: %{of} = NEVER_CHANGED
// RUN: %{passes}
// REDEFINE: %{of} = MADE_AT_START
// RUN: %{passes}
// REDEFINE: %{of} = CONSTANT
// RUN: %{passes}
// REDEFINE: %{of} = MADE_HERE
// RUN: %{passes}
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#if defined(REFERENCE)
struct Law {
  double &of;
};
static double gain = 2;
void change(double to) { gain = to; }
double kern(double x) {
  auto [of] = Law{gain};
  return of * x;
}

#elif defined(BITS)
struct Limits {
  unsigned order : 3, sign : 1;
};
static Limits limits{2, 1};
void change(int to) { limits.order = to & 7; }
double kern(double x) { return limits.order * x; }

#elif defined(HEAP)
struct Settings {
  int *order = new int(2);
  int *find() const { return order; }
};
static Settings *settings = new Settings;
void change(int to) { *settings->order = to; }
double kern(double x) { return x * __atomic_load_n(settings->find(), __ATOMIC_RELAXED); }

#elif defined(RANGE)
static int cells[2] = {1, 2};
static int const made[2] = {1, 2};
int first() { return ++cells[0]; }
double kern(double x) {
  std::ranges::copy(made, cells);
  return 2 * x;
}

#elif defined(PRINTED)
struct Told {
  unsigned often : 3, late : 1;
};
static Told told{1, 0};
void tell(int often) { told.often = often & 7; }
double kern(double x) {
  if (told.often > 0) std::puts("called");
  return 2 * x;
}

#elif defined(LOCKED)
struct Guarded {
  std::mutex mutex;
  std::shared_ptr<int> order = std::make_shared<int>(2);
};
static Guarded *const guarded = new Guarded;
static std::mutex other;
double kern(double x) {
  std::scoped_lock const lock(guarded->mutex, other);
  std::shared_ptr<int> const copy = guarded->order;
  return 2 * x;
}

#elif defined(NEVER_CHANGED)
static int order = 2;
static double const table[2] = {std::sqrt(2), std::sqrt(3)};
static std::vector<double> const more = {1, 2, 3};
double kern(double x) { return x * order + table[1] * more[2]; }

#elif defined(MADE_AT_START)
static std::map<std::string, double> const gains = {{"slow", 1}, {"fast", 2}};
double kern(double x) { return x * gains.at("fast"); }

#elif defined(CONSTANT)
static int const order = 3;
double kern(double x) {
  static std::vector<double> const powers(order, 2.0);
  double sum = 0;
  for (double one : powers) sum += one * x;
  return sum;
}

#else
double kern(double x) {
  auto numbers = std::make_unique<std::vector<double>>(3, x);
  std::sort(numbers->begin(), numbers->end());
  std::map<int, double> sums;
  for (int k = 0; k < 3; ++k) sums[k] += (*numbers)[k];
  return sums[1];
}
#endif
