// Pointers that the kernel changes and that outlive it: the next call would follow others.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not="[SYM"
// RUN: not ls %t.c
// Scratch is read before it is written here, so that it is none.
// RUN: not %symreal generate %s -o %t.c -- -DDECLARED 2>&1 | FileCheck %s --check-prefix=DECLARED
// DECLARED: kept_pointers.cpp:18:17: error: kernel 'step' reads 'law', which is neither input nor parameter [SYM017]
// DECLARED-NOT: SYM053
// A second call shows it.
// RUN: %symreal generate %s -o %t.c --frozen=allow -- -DDECLARED
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

// CHECK-DAG: kept_pointers.cpp:18:17: error: the kernel writes 'law', which is not an output [SYM053]
// CHECK-DAG: kept_pointers.cpp:38:3: error: the kernel writes 'current', which is not an output [SYM053]
// CHECK-DAG: kept_pointers.cpp:39:3: error: the kernel writes 'previous', which is not an output [SYM053]
// CHECK-DAG: kept_pointers.cpp:40:3: error: the kernel writes 'cursor.at', which is not an output [SYM053]
// CHECK-DAG: kept_pointers.cpp:41:3: error: the kernel writes 'cursor.next', which is not an output [SYM053]
// CHECK: help:
