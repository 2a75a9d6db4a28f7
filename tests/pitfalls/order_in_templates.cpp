// An iterator that a function of the library steps back is its own; and a template may be instantiated for numbers, whose
// operators are the language's, and for a class.
// RUN: %rewrite %s | FileCheck %s
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <complex>
#include <cstdio>
#include <list>

static int calls = 0;
struct Gamma {
  [[gnu::noinline]] double value(double x) const { return x + ++calls; }
};
template <class T> static T series(double nu, T const &x) { return 0.5 * x / Gamma().value(3.5 + nu); }
// CHECK: return series<T>(-nu, x) - REAL_LATER(series<T>(nu, x));
template <class T> static T difference(double nu, T const &x) { return series<T>(-nu, x) - series<T>(nu, x); }

// Nothing in a decltype is evaluated.
template <class Left, class Right>
static auto less(Left left, Right right) -> decltype(Left(left++) < Right(left++ + right)) {
  return left < right;
}

// Nor does a macro change the order, where one of its arguments has both operands.
#define TWICE(x) (2.0 * (x))

struct Solver {
  double tolerance;
  // CHECK: return REAL_READ({{.*}}, errors.back()) < REAL_READ({{.*}}, tolerance);
  bool done(std::list<double> const &errors) const { return errors.back() < tolerance; }
};

int main() {
  double x = 0.5, y;
#pragma symreal input(x) range(0.1, 0.7) scratch(calls)
  calls = 0;
  std::list<double> const errors = {x, 2 * x};
  y = difference<double>(2.0, x);
  y += std::imag(difference<std::complex<double>>(2.0, std::complex<double>(x, 1.0)));
  // CHECK: TWICE(Gamma().value(x) / REAL_LATER(Gamma().value(x))), integer = TWICE(2);
  double const quotient = TWICE(Gamma().value(x) / Gamma().value(x)), integer = TWICE(2);
  y += quotient + integer;
  y += Solver{1.5}.done(errors) && less(2.0, 3.0) ? x : 0.0;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
