// Plain numbers that the kernel leaves behind are state like others, even where the same number was there before.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c --decisions=guard 2>&1 | FileCheck %s --implicit-check-not="[SYM"
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c --decisions=guard -- -DDECLARED 2>&1 | FileCheck %s --check-prefix=DECLARED --implicit-check-not="[SYM"
// DECLARED: kernel step
// RUN: %symreal verify %s %t.c --samples=200 -- -DDECLARED

#include <cmath>
#include <cstdio>

double last = 1;
static double same = 2;

struct Controller {
  double i, sum;
  std::pair<double, int> mode;
};

struct Flags {
  double sw[3];
};

void reset(Flags *flags) {
  for (int k = 0; k < 3; k++) flags->sw[k] = k;
}

#ifdef DECLARED
#pragma symreal function input(e, p.i, p.sum) output(return, p.i, p.sum) scratch(last, same, flags->sw[0:3], p.mode)
#else
#pragma symreal function input(e, p.i, p.sum) output(return, p.sum)
#endif
double step(Controller &p, double e, Flags *flags) {
  last = 3.0;
  same = 2.0;
  reset(flags);
  p.sum += e;
  p.mode = {1.0, 2};
  if (std::fabs(e) < 1)
    p.i = 0.0;
  else
    p.i += e;
  return e + p.i;
}

int main() {
  Controller controller = {5, 0, {0, 0}};
  Flags flags = {{7, 7, 7}};
  std::printf("%g\n", step(controller, 0.5, &flags));
}

// CHECK-DAG: kept_constants.cpp:12:8: error: the kernel writes 'last', which is not an output [SYM053]
// CHECK-DAG: kept_constants.cpp:13:15: error: the kernel writes 'same', which is not an output [SYM053]
// CHECK-DAG: kept_constants.cpp:25:31: error: the kernel writes 'flags->sw[k]', which is not an output [SYM053]
// CHECK-DAG: kept_constants.cpp:38:3: error: the kernel writes 'p.mode', which is not an output [SYM053]
// CHECK-DAG: kept_constants.cpp:40:5: error: the kernel writes 'p.i', which is not an output [SYM053]
// CHECK: help:
