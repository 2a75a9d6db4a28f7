// Pointers that the kernel changes and that outlive it: the next call would follow others.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not="[SYM"
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c -- -DDECLARED 2>&1 | FileCheck %s --check-prefix=DECLARED --implicit-check-not="[SYM"
// DECLARED: kernel step
// The pointers are read before they are written, so they are no scratch, which shows in a second call.
// RUN: not %symreal verify %s %t.c --samples=100 -- -DDECLARED 2>&1 | FileCheck %s --check-prefix=AGAIN
// AGAIN: error: called again, 1 of 1 outputs differ from the original

#include <cstdio>

static double linear(double x) { return x; }
static double square(double x) { return x * x; }
static double (*law)(double) = linear;

static double buffers[2][1] = {{1}, {2}};
static double *current = buffers[0], *previous = buffers[1];

struct Cursor {
  double const *at;
  double (Cursor::*next)(double) const;
  double same(double x) const { return x; }
};

#ifdef DECLARED
#pragma symreal function input(x) constant(buffers) scratch(law, current, previous, cursor.at, cursor.next) output(return)
#else
#pragma symreal function input(x) constant(buffers) output(return)
#endif
double step(Cursor &cursor, double x) {
  double const y = law(x) + *current;
  law = square;
  double *kept = current;
  current = previous;
  previous = kept;
  cursor.at++;
  cursor.next = &Cursor::same;
  double const *local = buffers[0]; // goes with the call
  local = buffers[1];
  return y + *local;
}

int main() {
  Cursor cursor = {buffers[0], nullptr};
  std::printf("%g\n", step(cursor, 0.5));
}

// CHECK-DAG: kept_pointers.cpp:33:3: error: the kernel writes 'law', which is not an output [SYM053]
// CHECK-DAG: kept_pointers.cpp:35:3: error: the kernel writes 'current', which is not an output [SYM053]
// CHECK-DAG: kept_pointers.cpp:36:3: error: the kernel writes 'previous', which is not an output [SYM053]
// CHECK-DAG: kept_pointers.cpp:37:3: error: the kernel writes 'cursor.at', which is not an output [SYM053]
// CHECK-DAG: kept_pointers.cpp:38:3: error: the kernel writes 'cursor.next', which is not an output [SYM053]
// CHECK: help:
