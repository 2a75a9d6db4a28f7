// A wrapper compares how far apart pointers lie of which one ends what another begins, and the bit-fields of a structure by
// value. Arguments that it cannot compare are refused, and so is an object that may be empty.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: cd %t && %symreal generate %s -o ./ --wrapper -- -std=c++20
// RUN: cd %t && %symreal verify %s stepped.c ended.c until.c summed.c bits.c --samples=30 -- -std=c++20
// RUN: cd %t && %cxx -std=c++20 -Wno-unknown-pragmas %s -o original && ./original > expected
// DEFINE: %{objects} = stepped.o ended.o until.o summed.o bits.o
// RUN: cd %t && %cc -c stepped.c ended.c until.c summed.c bits.c && %cxx -std=c++20 -Wno-unknown-pragmas stepped_wrapper.cpp %{objects} -o swapped && ./swapped | diff expected -
// DEFINE: %{name} =
// DEFINE: %{refused} = not %symreal generate %s --kernel %{name} -o %t/refused.c --wrapper -- -std=c++20 -DREFUSED 2>&1 | FileCheck %s --check-prefix
// REDEFINE: %{name} = wide
// RUN: %{refused}=WIDE
// WIDE: error: --wrapper cannot compare 'unit' of 'wide', which is baked in: it is text of wide characters [SYM095]
// REDEFINE: %{name} = function
// RUN: %{refused}=FUNCTION
// FUNCTION: error: --wrapper cannot compare 'of' of 'function', which is baked in: a function that is called through it is part of the recording [SYM095]
// REDEFINE: %{name} = atomic
// RUN: %{refused}=ATOMIC
// ATOMIC: error: --wrapper cannot compare 'order' of 'atomic', which is baked in: it is a std::atomic [SYM095]
// REDEFINE: %{name} = deduced
// RUN: %{refused}=DEDUCED
// DEDUCED: error: --wrapper cannot compare 'order' of 'deduced', which is baked in: its type depends on the template [SYM095]
// REDEFINE: %{name} = united
// RUN: %{refused}=UNITED
// UNITED: error: --wrapper cannot compare 'word' of 'united', which is baked in: it is a union [SYM095]
// REDEFINE: %{name} = opaque
// RUN: %{refused}=OPAQUE
// OPAQUE: error: --wrapper cannot compare 'list' of 'opaque', which is baked in: it is a std::map [SYM095]
#include <cstdio>

#ifndef REFUSED
#include <numeric>
static double numbers[4] = {1, 2, 3, 4};

#pragma symreal function input(x[0:2]) output(return)
static double stepped(double const *x, double const *end) {
  double sum = 0;
  for (; x < end; ++x) sum = 2 * sum + *x;
  return sum;
}

// The kernel is recorded on a copy of numbers that cannot be written, in which both pointers lie.
static double const fixed[3] = {1, 2, 3};
#pragma symreal function input(x[0:2]) output(return)
static double ended(double const *x, double const *end) {
  double sum = *x;
  while (++x != end) sum = 2 * sum + *x;
  return sum;
}

#pragma symreal function input(x) constant(order[0:2]) output(return)
static double until(double x, int const *order, int const *end) {
  double sum = 0;
  for (int const *each = order; each != end; ++each) sum += *each * x;
  return sum;
}
static int const orders[3] = {1, 2, 3};

#pragma symreal function input(x[0:2]) output(return)
static double summed(double const *x, double const *end) { return std::accumulate(x, end, 0.0); }

struct Mode {
  unsigned order : 3, sign : 1;
};
#pragma symreal function input(x) output(return)
static double bits(double x, Mode mode) { return x * mode.order; }

int main() {
  double const recorded[5] = {stepped(numbers, numbers + 2), ended(fixed, fixed + 2), until(0.5, orders, orders + 2),
                              summed(numbers, numbers + 2), bits(0.5, {1, 0})};
  double const others[5] = {stepped(numbers, numbers + 1), ended(fixed, fixed + 3), until(0.5, orders, orders + 3),
                            summed(numbers, numbers + 1), bits(0.5, {3, 0})};
  for (int k = 0; k < 5; ++k) std::printf("%.17g %.17g\n", recorded[k], others[k]);
}

#else
#include <atomic>
#include <map>

#pragma symreal function input(x) output(return)
static double wide(double x, wchar_t const *unit) { return unit[0] == L'm' ? x : 1000 * x; }

static int once(int of) { return of; }
static int twice(int of) { return 2 * of; }
#pragma symreal function input(x) output(return)
static double function(double x, int (&of)(int)) { return of(3) * x; }

#pragma symreal function input(x) constant(order) output(return)
static double atomic(double x, std::atomic<int> const &order) { return x * order.load(); }

#pragma symreal function input(x) output(return)
static double deduced(double x, auto order) { return x * order; }

union Word {
  int i;
  float f;
};
#pragma symreal function input(x) output(return)
static double united(double x, Word word) { return x * word.i; }

#pragma symreal function input(x) output(return)
static double opaque(double x, std::map<int, double> const &list) { return list.empty() ? x : 2 * x; }

int main() {
  std::printf("%g %g\n", wide(0.5, L"m"), wide(0.5, L"km"));
  std::printf("%g %g\n", function(0.5, once), function(0.5, twice));
  std::printf("%g %g\n", atomic(0.5, 1), atomic(0.5, 2));
  std::printf("%g %g\n", deduced(0.5, 1), deduced(0.5, 2));
  std::printf("%g %g\n", united(0.5, {1}), united(0.5, {2}));
  std::printf("%g %g\n", opaque(2, {}), opaque(2, {{1, 2}}));
}
#endif
