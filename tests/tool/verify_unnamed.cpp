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
// REDEFINE: %{of} = TUPLE
// RUN: %{finds}
// TUPLE: error: kernel 'kern': the outputs of the original depend on 'limits' ({{.*}}), which no clause names [SYM017]
// REDEFINE: %{of} = HEAP
// RUN: %{finds}
// HEAP: error: kernel 'kern': the outputs of the original depend on a block of 4 bytes on the heap ({{.*}}), which no clause names [SYM017]
// REDEFINE: %{of} = FILLED
// RUN: %{finds}
// FILLED: error: kernel 'kern': the original overwrites 'cells' ({{.*}}) with the bytes that it holds [SYM121]
// REDEFINE: %{of} = UNINITIALISED
// RUN: %{finds}
// UNINITIALISED: error: kernel 'kern': the original overwrites 'cells' ({{.*}}) with the bytes that it holds [SYM121]

// What is read and does not matter is no state, nor is what never changes, or what the clauses need to name numbers.
// REDEFINE: %{of} = PRINTED
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
#include <string>
#include <tuple>
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

#elif defined(TUPLE)
static std::tuple<int, float> limits{1, 2};
void change(int to) { limits = {to, 1}; }
double kern(double x) {
  return std::apply([](int a, float b) { return a + b; }, limits) * x;
}

#elif defined(HEAP)
struct Settings {
  int *order = new int(2);
  int *find() const { return order; }
};
static Settings *settings = new Settings;
void change(int to) { *settings->order = to; }
double kern(double x) { return x * __atomic_load_n(settings->find(), __ATOMIC_RELAXED); }

#elif defined(FILLED)
struct Cells {
  int all[3] = {};
  void clear() { std::fill_n(all, 3, 0); }
};
static Cells cells;
int first() { return ++cells.all[0]; }
double kern(double x) {
  cells.clear();
  return 2 * x;
}

#elif defined(UNINITIALISED)
static int cells[2] = {1, 2};
static int const made[2] = {1, 2};
int first() { return ++cells[0]; }
double kern(double x) {
  std::uninitialized_copy(made, made + 2, cells);
  return 2 * x;
}

#elif defined(PRINTED)
static std::tuple<int> told{1};
void tell(int often) { told = often; }
double kern(double x) {
  if (std::apply([](int often) { return often > 0; }, told)) std::puts("called");
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
