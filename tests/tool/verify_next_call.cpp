// State that the program changes between two calls of a kernel, and the recording bakes in without a word, shows in its own
// next call: verify runs the original there as well.
// DEFINE: %{of} =
// DEFINE: %{try} = %symreal generate %s -o %t.c -- -std=c++17 -D%{of} && %symreal verify %s %t.c --samples=20 --min-samples=5 -- -std=c++17 -D%{of}
// REDEFINE: %{of} = ATOMIC
// RUN: %symreal generate %s -o %t.c -- -std=c++17 -D%{of} && not %symreal verify %s %t.c --samples=20 --min-samples=5 -- -std=c++17 -D%{of} 2>&1 | FileCheck %s
// CHECK: error: in the program's next call the original gives other outputs on 4 samples: it reads something that the recording has baked in, and that the program changes [SYM091]
// REDEFINE: %{of} = REFERENCE
// RUN: %symreal generate %s -o %t.c -- -std=c++17 -D%{of} && not %symreal verify %s %t.c --samples=20 --min-samples=5 -- -std=c++17 -D%{of} 2>&1 | FileCheck %s

// An argument that no clause names may be another; so may what is said to be constant. State that is kept is fed.
// REDEFINE: %{of} = ARGUMENT
// RUN: %{try}
// REDEFINE: %{of} = CONSTANT
// RUN: %{try}
// REDEFINE: %{of} = KEPT
// RUN: %{try}
// Arguments that lie in one place there are another matter.
// REDEFINE: %{of} = IN_PLACE
// RUN: %{try}
// REDEFINE: %{of} = EXTENTS
// RUN: %{try}
#include <cstdio>
#include <functional>
#include <string>

#if defined(ATOMIC)
static int mode = 1, *const at = &mode;
#pragma symreal function input(x) output(return)
static double kern(double x) { return (__atomic_load_n(at, __ATOMIC_RELAXED) == 1 ? x : 2 * x) + 1; }
static double call() { return kern(0.5); }
static void change() { mode = 2; }

#elif defined(REFERENCE)
struct Law {
  virtual double of(double x) const { return x; }
};
struct Twice : Law {
  double of(double x) const override { return 2 * x; }
};
static Law once;
static Twice twice;
static std::reference_wrapper<Law> law = once;
#pragma symreal function input(x) output(return)
static double kern(double x) { return law.get().of(x) + 1; }
static double call() { return kern(0.5); }
static void change() { law = twice; }

#elif defined(ARGUMENT)
static char const *unit = "m";
#pragma symreal function input(x) output(return)
static double kern(double x, std::string const &unit) { return unit == "m" ? x : 1000 * x; }
static double call() { return kern(0.5, unit); }
static void change() { unit = "km"; }

#elif defined(CONSTANT)
static int order = 1;
#pragma symreal function input(x) constant(order) output(return)
static double kern(double x) { return order == 1 ? x : x * x; }
static double call() { return kern(0.5); }
static void change() { order = 2; }

#elif defined(KEPT)
static double sum = 1;
#pragma symreal function input(x, sum) output(return, sum)
static double kern(double x) { return sum += x; }
static double call() { return kern(0.5); }
static void change() { sum = 7; }

#elif defined(IN_PLACE)
static double a[2] = {1, 2}, b[2], *to = b;
#pragma symreal function input(x[0:2]) output(y[0:2])
static void kern(double const *x, double *y) {
  y[0] = x[1];
  y[1] = x[0] + x[1];
}
static double call() { return kern(a, to), to[1]; }
static void change() { to = a; }

#else
static int count = 2;
static double a[3] = {1, 2, 3};
#pragma symreal function input(x[0:n]) output(return)
static double kern(double const *x, int n) {
  double sum = 0;
  for (int k = 0; k < n; ++k) sum += x[k];
  return sum;
}
static double call() { return kern(a, count); }
static void change() { count = 3; }
#endif

int main() {
  double const first = call();
  change();
  std::printf("%g %g\n", first, call());
}
