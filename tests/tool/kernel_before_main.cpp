// A kernel that runs while the program's static variables are initialised is recorded and verified as any other.
// RUN: rm -rf %t && %symreal generate %s -o %t/
// RUN: %symreal verify %s %t/initial.c %t/built.c %t/constructed.c %t/shared.c --samples=60 --min-samples=50
#include <cmath>
#include <cstdio>
#include <vector>

#pragma symreal function input(x) output(return)
static double initial(double x) { return std::sin(x) * 2 + x; }
static double const start = initial(1);

// Before and behind it stand other static objects.
static std::vector<double> const weights{1, 2, 4};
struct Filter {
  double value;
#pragma symreal function input(x) constant(weights) output(return)
  static double built(double x) { return weights[1] * x + weights[2] / (1 + x * x); }
  Filter() : value(built(start)) {}
};
static Filter const filter;

#pragma symreal function input(x) output(return)
static double constructed(double x) { return std::exp(-x) + x; }
static double before_all;
[[gnu::constructor(150)]] static void fill() { before_all = constructed(0.5); }

#pragma symreal function input(x) output(y)
static void shared(double x, double &y) { y = x * x; }
template <class T> struct Table {
  static inline T const first = [] {
    T y;
    shared(T(3), y);
    return y;
  }();
};

int main() {
  std::printf("%g %g %g %g %g\n", start, filter.value, before_all, Table<double>::first, initial(2));
}
