// State that the program changes between two calls of a kernel, and the recording bakes in without a word, shows in its own
// next call: verify runs the original there as well.
// RUN: rm -rf %t && mkdir %t
// RUN: cd %t && %symreal generate %s -o ./ -- -std=c++17
// RUN: cd %t && not %symreal verify %s atomic.c reference.c --samples=20 --min-samples=5 -- -std=c++17 2>&1 | FileCheck %s
// CHECK: kernel atomic,
// CHECK: error: in the program's next call the original gives other outputs on 4 samples: it reads something that the recording has baked in, and that the program changes [SYM091]
// CHECK: kernel reference,
// CHECK: error: in the program's next call the original gives other outputs on 4 samples: it reads something that the recording has baked in, and that the program changes [SYM091]

// An argument that no clause names may be another; so may what is said to be constant. State that is kept is fed. Arguments
// that lie in one place there are another matter.
// RUN: cd %t && %symreal verify %s named.c kept.c in_place.c extents.c --samples=20 --min-samples=5 -- -std=c++17
// RUN: cd %t && %symreal generate %s -o argument.c -- -std=c++17 -DARGUMENT
// RUN: cd %t && %symreal verify %s argument.c --samples=20 --min-samples=5 -- -std=c++17 -DARGUMENT
#include <cstdio>

#ifdef ARGUMENT
#include <string>
static char const *unit = "m";
#pragma symreal function input(x) output(return)
static double argument(double x, std::string const &unit) { return unit == "m" ? x : 1000 * x; }
static double calls() { return argument(0.5, unit); }
static void change() { unit = "km"; }

#else
#include <functional>
static int mode = 1, *const at = &mode;
#pragma symreal function input(x) output(return)
static double atomic(double x) { return (__atomic_load_n(at, __ATOMIC_RELAXED) == 1 ? x : 2 * x) + 1; }

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
static double reference(double x) { return law.get().of(x) + 1; }

static int order = 1;
#pragma symreal function input(x) constant(order) output(return)
static double named(double x) { return order == 1 ? x : x * x; }

static double sum = 1;
#pragma symreal function input(x, sum) output(return, sum)
static double kept(double x) { return sum += x; }

static double a[2] = {1, 2}, b[2], *to = b;
#pragma symreal function input(x[0:2]) output(y[0:2])
static void in_place(double const *x, double *y) {
  y[0] = x[1];
  y[1] = x[0] + x[1];
}

static int count = 2;
static double numbers[3] = {1, 2, 3};
#pragma symreal function input(x[0:n]) output(return)
static double extents(double const *x, int n) {
  double sum = 0;
  for (int k = 0; k < n; ++k) sum += x[k];
  return sum;
}

static double calls() {
  in_place(a, to);
  return atomic(0.5) + reference(0.5) + named(0.5) + kept(0.5) + to[1] + extents(numbers, count);
}

static void change() {
  mode = 2;
  law = twice;
  order = 2;
  sum = 7;
  to = a;
  count = 3;
}
#endif

int main() {
  double const first = calls();
  change();
  std::printf("%g %g\n", first, calls());
}
