// Code of libraries is not rewritten, so nothing tells that it writes: a number that is another one than when the kernel began
// was written, and no result depends on what the caller had there.
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=50
// RUN: not %symreal generate %s -o %t2.c -- -DREAD_FIRST 2>&1 | FileCheck %s
// CHECK: error: a result depends on what output 'w[1]' held before (3) [SYM136]
#include <algorithm>
#include <cstdio>

#pragma symreal function input(x) output(w[0:3], return)
double copied(double x, double *w) {
#ifdef READ_FIRST
  x *= w[1];
#endif
  double const from[3] = {x, 4.5, 0.75};
  std::copy(from, from + 3, w);
  std::swap(w[0], w[2]);
  for (int k = 0; k < 3; ++k) w[k] += x;
  return w[1] * x;
}
int main() {
  double w[3] = {1, 3, 2};
  std::printf("%g\n", copied(0.5, w));
}
