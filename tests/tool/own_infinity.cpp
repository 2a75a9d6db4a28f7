// An infinity that is a constant of the program, and is compared with and handed on, does not put a sample outside of
// premise P1: "none yet", "no limit". Whether one is left is asked where the code runs.
// RUN: %symreal generate %s -o %t.c --decisions=select 2>/dev/null && FileCheck %s --input-file=%t.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -c %t.c -o %t.o
#include <cmath>
#include <cstdio>
#include <limits>

// CHECK: INFINITY
// SAME: {{1[0-9][0-9]}} within the premises
// SAME: return 1 0 0
// SAME: y[0] 5 0 0
#pragma symreal function input(x[0:4]) range(-2, 2) output(return, y[0:5])
double nearest(double const *x, double *y) {
  double best = std::numeric_limits<double>::infinity(), second = HUGE_VAL;
  for (int i = 0; i < 4; ++i)
    if (x[i] > 1) {
      if (x[i] < best) best = x[i];
      second = std::fmin(second, x[i] * x[i]);
    }
  y[0] = best;
  y[1] = second == HUGE_VAL ? 1.0 : std::sqrt(second);
  y[2] = std::isinf(best) ? -1.0 : best;
  y[3] = std::isfinite(-second) ? 3.0 : 4.0;
  y[4] = std::fabs(best) == std::fabs(best) ? 1.0 : 2.0;
  return x[0] == HUGE_VAL ? 1 : x[0];
}

int main() {
  double const x[4] = {1.5, 0.5, 1.25, -1};
  double y[5], result = nearest(x, y);
  std::printf("%g %g %g\n", result, y[0], y[2]);
}
