// An input that the kernel changes in place is seen by the caller: it is an output as well, or scratch.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not="[SYM"
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c -- -DDECLARED 2>&1 | FileCheck %s --check-prefix=DECLARED --implicit-check-not="[SYM"
// DECLARED: kernel step
// RUN: %symreal verify %s %t.c --samples=100 -- -DDECLARED

#include <algorithm>
#include <cstdio>

struct State {
  double position, speed;
};

#ifdef DECLARED
#pragma symreal function input(x[0:2], state.position, state.speed, own, list[0:2]) parameter(mass) output(return, x[0:2], state.position) scratch(mass, state.speed, list[0:2])
#else
#pragma symreal function input(x[0:2], state.position, state.speed, own, list[0:2]) parameter(mass) output(return)
#endif
double step(double *x, State &state, double &mass, double *list, double own) {
  x[0] *= 2;
  x[1] = x[1];
  state = {state.position + state.speed, 0.0};
  mass += 1;
  own *= 2; // it is a copy
  std::swap(list[0], list[1]);
  return x[0] * mass + own + list[0];
}

int main() {
  double x[2] = {1, 2}, mass = 3, list[2] = {4, 5};
  State state = {6, 7};
  std::printf("%g\n", step(x, state, mass, list, 8));
}

// CHECK-DAG: changed_inputs.cpp:19:{{[0-9]+}}: error: the kernel writes input 'x[0:2]', which is not an output [SYM053]
// CHECK-DAG: changed_inputs.cpp:24:3: error: the kernel writes 'state', which is not an output [SYM053]
// CHECK-DAG: changed_inputs.cpp:19:{{[0-9]+}}: error: the kernel writes input 'list[0:2]', which is not an output [SYM053]
// CHECK-DAG: changed_inputs.cpp:19:{{[0-9]+}}: error: the kernel writes input 'mass', which is not an output [SYM053]
// CHECK: help:
