// A bit-field as an operand whose order of evaluation matters: no reference can be bound to it.
// RUN: %rewrite %s -- | FileCheck %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=50 --min-samples=10
#include <algorithm>
#include <cstdio>

struct Parts {
  signed int few : 7;
  unsigned long long many : 40;
  bool is_set : 1;
  double number;
};

static double doubled(Parts &parts) {
  parts.few += 1;
  return parts.number *= 2;
}

#pragma symreal function input(x) output(return)
double computed(double x) {
  Parts parts{3, 1ull << 36, true, x};
  // CHECK: doubled(parts) - REAL_LATER(parts.few)
  double sum = doubled(parts) - parts.few;
  sum += doubled(parts) * parts.many + doubled(parts) / parts.is_set;
  return sum;
}
int main() { std::printf("%g\n", computed(0.5)); }
