// A wrapper compares how far apart pointers lie of which one ends what another begins, and the bit-fields of a structure by
// value. Arguments that it cannot compare are refused.
// RUN: rm -rf %t && mkdir %t && cd %t
// DEFINE: %{kernel} =
// DEFINE: %{flags} = -std=c++20 -D%{kernel}
// DEFINE: %{try} = cd %t && %symreal generate %s -o k.c --wrapper -- %{flags} && %cc -c k.c && %cxx %{flags} -Wno-unknown-pragmas k_wrapper.cpp k.o -o swapped && %cxx %{flags} -Wno-unknown-pragmas %s -o original && ./original > expected && ./swapped | diff - expected && %symreal verify %s k.c --samples=30 -- %{flags}
// DEFINE: %{refused} = cd %t && not %symreal generate %s -o o.c --wrapper -- %{flags} 2>&1 | FileCheck %s --check-prefix=%{kernel}
// REDEFINE: %{kernel} = STEPPED
// RUN: %{try}
// REDEFINE: %{kernel} = CONSTANT
// RUN: %{try}
// REDEFINE: %{kernel} = UNTIL
// RUN: %{try}
// REDEFINE: %{kernel} = LIBRARY
// RUN: %{try}
// REDEFINE: %{kernel} = BITS
// RUN: %{try}
// REDEFINE: %{kernel} = WIDE
// RUN: %{refused}
// WIDE: error: --wrapper cannot compare 'unit' of 'kern', which is baked in: it is text of wide characters [SYM095]
// REDEFINE: %{kernel} = FUNCTION
// RUN: %{refused}
// FUNCTION: error: --wrapper cannot compare 'of' of 'kern', which is baked in: a function that is called through it is part of the recording [SYM095]
// REDEFINE: %{kernel} = ATOMIC
// RUN: %{refused}
// ATOMIC: error: --wrapper cannot compare 'order' of 'kern', which is baked in: it is a std::atomic [SYM095]
// REDEFINE: %{kernel} = DEDUCED
// RUN: %{refused}
// DEDUCED: error: --wrapper cannot compare 'order' of 'kern', which is baked in: its type depends on the template [SYM095]
// REDEFINE: %{kernel} = UNION
// RUN: %{refused}
// UNION: error: --wrapper cannot compare 'word' of 'kern', which is baked in: it is a union [SYM095]
#include <atomic>
#include <cstdio>
#include <numeric>

[[maybe_unused]] static double numbers[4] = {1, 2, 3, 4};

#if defined(STEPPED)
#pragma symreal function input(x[0:2]) output(return)
static double kern(double const *x, double const *end) {
  double sum = 0;
  for (; x < end; ++x) sum = 2 * sum + *x;
  return sum;
}
static double first() { return kern(numbers, numbers + 2); }
static double other() { return kern(numbers, numbers + 1); }

#elif defined(CONSTANT)
// The kernel is recorded on a copy of numbers that cannot be written, in which both pointers lie.
static double const fixed[3] = {1, 2, 3};
#pragma symreal function input(x[0:2]) output(return)
static double kern(double const *x, double const *end) {
  double sum = *x;
  while (++x != end) sum = 2 * sum + *x;
  return sum;
}
static double first() { return kern(fixed, fixed + 2); }
static double other() { return kern(fixed, fixed + 3); }

#elif defined(UNTIL)
#pragma symreal function input(x) constant(order[0:2]) output(return)
static double kern(double x, int const *order, int const *end) {
  double sum = 0;
  for (int const *each = order; each != end; ++each) sum += *each * x;
  return sum;
}
static int const orders[3] = {1, 2, 3};
static double first() { return kern(0.5, orders, orders + 2); }
static double other() { return kern(0.5, orders, orders + 3); }

#elif defined(LIBRARY)
#pragma symreal function input(x[0:2]) output(return)
static double kern(double const *x, double const *end) { return std::accumulate(x, end, 0.0); }
static double first() { return kern(numbers, numbers + 2); }
static double other() { return kern(numbers, numbers + 1); }

#elif defined(BITS)
struct Mode {
  unsigned order : 3, sign : 1;
};
#pragma symreal function input(x) output(return)
static double kern(double x, Mode mode) { return x * mode.order; }
static double first() { return kern(0.5, {1, 0}); }
static double other() { return kern(0.5, {3, 0}); }

#elif defined(WIDE)
#pragma symreal function input(x) output(return)
static double kern(double x, wchar_t const *unit) { return unit[0] == L'm' ? x : 1000 * x; }
static double first() { return kern(0.5, L"m"); }
static double other() { return kern(0.5, L"km"); }

#elif defined(FUNCTION)
static int once(int of) { return of; }
static int twice(int of) { return 2 * of; }
#pragma symreal function input(x) output(return)
static double kern(double x, int (&of)(int)) { return of(3) * x; }
static double first() { return kern(0.5, once); }
static double other() { return kern(0.5, twice); }

#elif defined(ATOMIC)
#pragma symreal function input(x) constant(order) output(return)
static double kern(double x, std::atomic<int> const &order) { return x * order.load(); }
static double first() { return kern(0.5, 1); }
static double other() { return kern(0.5, 2); }

#elif defined(DEDUCED)
#pragma symreal function input(x) output(return)
static double kern(double x, auto order) { return x * order; }
static double first() { return kern(0.5, 1); }
static double other() { return kern(0.5, 2); }

#else
union Word {
  int i;
  float f;
};
#pragma symreal function input(x) output(return)
static double kern(double x, Word word) { return x * word.i; }
static double first() { return kern(0.5, {1}); }
static double other() { return kern(0.5, {2}); }
#endif

int main() {
  double const one = first();
  std::printf("%.17g %.17g\n", one, other());
}
