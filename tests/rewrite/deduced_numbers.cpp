// What a template deduces a type from becomes a REAL in the instantiation for double, and stays what it is in others.
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s
// RUN: %symreal generate %s -o %t.c
// RUN: FileCheck %s --check-prefix=CODE < %t.c
// RUN: %symreal verify %s %t.c --samples=100
#include <cstdio>
#include <limits>

struct Math {
  template <typename T> static T square(T x) { return x * x; }
  template <typename T> static T bounded(T x);
};

template <typename T> T Math::bounded(T x) {
  // CHECK: static const T overflow = 1 / square(REAL_DEDUCED(std::numeric_limits<T>::epsilon()));
  static const T overflow = 1 / square(std::numeric_limits<T>::epsilon());
  // CHECK: return REAL_FIT(x + overflow * square(REAL_C(0.5)));
  return x + overflow * square(0.5);
}

template float Math::bounded<float>(float);
template double Math::bounded<double>(double);
template long double Math::bounded<long double>(long double);

// CODE: input[0] + 5.070602400912918e+30;
#pragma symreal function input(x) output(return)
double kernel(double x) { return Math::bounded(x); }

int main() { std::printf("%g %g\n", kernel(0.5), (double)Math::bounded(0.5f)); }
