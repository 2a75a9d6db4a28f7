// What an output held before the kernel is no part of the result without a word.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c --decisions=select 2>&1 | FileCheck %s --implicit-check-not="[SYM" --check-prefixes=CHECK,SELECT
// RUN: not %symreal generate %s -o %t.c --decisions=guard -- -DX=-0.5 2>&1 | FileCheck %s --implicit-check-not="[SYM" --check-prefixes=CHECK,GUARD
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c --decisions=select -- -DDECLARED 2>&1 | FileCheck %s --check-prefix=DECLARED --implicit-check-not="[SYM"
// DECLARED: kernel step
// RUN: %symreal verify %s %t.c --samples=200 -- -DDECLARED
// RUN: %symreal generate %s -o %t.c --decisions=guard -- -DDECLARED -DX=-0.5
// RUN: %symreal verify %s %t.c --samples=200 -- -DDECLARED -DX=-0.5

#include <cstdio>

#ifndef X
#define X 1.5
#endif

struct Out {
  double held, grown, never, both, looped;
  double zeros[2];
};

#ifdef DECLARED
#pragma symreal function input(x, y[0:3], out.held, out.grown, out.looped) output(y[0:3], out.held, out.grown, out.both, out.looped, out.zeros)
#else
#pragma symreal function input(x) output(y[0:3], out.held, out.grown, out.never, out.both, out.looped, out.zeros)
#endif
void step(double x, double *y, Out &out) {
  y[0] = x;
  y[2] = y[2] + x;
  if (x > 0) out.held = x;
  if (x > 1)
    out.grown += x;
  else
    out.grown = 1;
  if (x > 1)
    out.both = x;
  else
    out.both = 4;
  double rest = x;
#pragma symreal loop(3)
  while (rest > 1) {
    out.looped = rest;
    rest = rest / 4;
  }
  for (double &zero : out.zeros) zero = 0.0;
  out.zeros[1] = x;
}

int main() {
  double y[3] = {1, 2, 3};
  Out out = {4, 5, 6, 7, 8, {0, 0}};
  step(X, y, out);
  std::printf("%g\n", y[0]);
}

// CHECK-DAG: unwritten_outputs.cpp:26:{{[0-9]+}}: error: the kernel does not write output 'y[0:3]' in element 1, which keeps what it held before (2) [SYM136]
// CHECK-DAG: unwritten_outputs.cpp:26:{{[0-9]+}}: error: the kernel does not write output 'out.never', which keeps what it held before (6) [SYM136]
// CHECK-DAG: unwritten_outputs.cpp:30:10: error: a result depends on what output 'y[2]' held before (3) [SYM136]
// SELECT-DAG: unwritten_outputs.cpp:31:14: error: a result depends on what output 'out.held' held before (4) [SYM136]
// SELECT-DAG: unwritten_outputs.cpp:33:5: error: a result depends on what output 'out.grown' held before (5) [SYM136]
// CHECK-DAG: unwritten_outputs.cpp:43:5: error: a result depends on what output 'out.looped' held before (8) [SYM136]
// GUARD-DAG: unwritten_outputs.cpp:26:{{[0-9]+}}: error: the kernel does not write output 'out.held', which keeps what it held before (4) [SYM136]
// CHECK: help:
