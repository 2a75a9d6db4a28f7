// One text of a template serves all its instances: where the returned type is another one, its conditions are plain and
// its precision is its own.
// RUN: %same %s
// RUN: %symreal generate %s --decisions=select -o %t.c && FileCheck %s < %t.c
// RUN: %symreal verify %s %t.c --samples=100 2>&1 | FileCheck %s --check-prefix=VERIFY
#include <cstdio>
#include <cstdlib>

template <class T> T saturated(T x, T limit) {
  if (x > limit) return limit;
  if (x < -limit) return -limit;
  return x;
}

// CHECK: ?
// VERIFY: 100 samples and 12 around decisions, 112 within the premises
#pragma symreal function input(x) range(-3, 3) output(return)
double kernel(double x) { return saturated(x, 1.5); }

int main() {
  if (saturated(0.1L, 1.0L) != 0.1L) std::abort(); // not rounded to double
  if (saturated(7.5F, 2.5F) != 2.5F || saturated(-9, 4) != -4) std::abort();
  std::printf("%g\n", kernel(2));
}
