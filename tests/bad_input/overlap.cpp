// A call whose output overlaps an input of another name says nothing about other calls.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not="[SYM"
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c -- -DAPART 2>&1 | FileCheck %s --check-prefix=APART --implicit-check-not="[SYM"
// APART: kernel step
// RUN: %symreal verify %s %t.c --samples=100 -- -DAPART
// RUN: %symreal generate %s -o %t.c -- -DONE_NAME 2>&1 | FileCheck %s --check-prefix=APART --implicit-check-not="[SYM"
// RUN: %symreal verify %s %t.c --samples=100 -- -DONE_NAME
#include <cstdio>

#ifdef ONE_NAME
#pragma symreal function input(x[0:3]) output(x[0:3])
#else
#pragma symreal function input(x[0:3]) output(y[0:3])
#endif
void step(double const *x, double *y) {
  y[0] = x[0] + 1;
  y[1] = x[0] * 2;
  y[2] = x[1] + x[2];
}

int main() {
  double x[3] = {0.5, 1.5, 2.5}, y[3] = {0, 0, 0};
#ifdef APART
  step(x, y);
#else
  step(x, x);
#endif
  std::printf("%g %g %g\n", x[0], x[1], y[2]);
}

// CHECK: overlap.cpp:15:{{[0-9]+}}: error: output 'y[0:3]' overlaps 'x[0:3]' ({{.*}}overlap.cpp:15:{{[0-9]+}}), so the result would hold only for calls with this overlap [SYM050]
