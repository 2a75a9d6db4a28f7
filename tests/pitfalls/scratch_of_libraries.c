// Scratch that the C library writes is called by its own name: only what it leaves unwritten counts as read.
// RUN: %symreal generate %s -o %t/ && %symreal verify %s %t/numbers.c %t/integers.c --samples=50
// RUN: not %symreal generate %s -o %t/ -- -DPART 2>&1 | FileCheck %s
// CHECK: error: kernel 'numbers' reads 'work' (2), which is neither input nor parameter [SYM017]
// CHECK: error: kernel 'integers' reads 'counts' (4), which is neither input nor parameter [SYM017]
#include <string.h>

static double work[3] = {1, 3, 2};
static int counts[3] = {5, 3, 4};
#ifdef PART
enum { length = 2 };
#else
enum { length = 3 };
#endif

#pragma symreal function input(x[0:2]) scratch(work[0:3]) output(y[0:1])
void numbers(double const *x, double *y) {
  memset(work, 0, length * sizeof *work);
  work[1] += x[0];
  y[0] = work[1] * x[1] + work[2];
}

#pragma symreal function input(x[0:2]) scratch(counts[0:3]) output(y[0:1])
void integers(double const *x, double *y) {
  static int const from[3] = {2, 3, 1};
  memcpy(counts, from, length * sizeof *counts);
  y[0] = counts[1] * x[1] + counts[2] + x[0];
}

int main(void) {
  double x[2] = {0.5, 1.5}, y[1];
  numbers(x, y);
  integers(x, y);
}
