// A decision is one diagnostic, however many call paths lead to it: with their number, and the shortest of them. It is
// said in the words of the source, and in those of the inputs where these tell more.
// RUN: not %symreal generate %s -o %t.c > %t.out 2>&1
// RUN: FileCheck %s < %t.out
// RUN: grep -c 'error:' %t.out | FileCheck %s --check-prefix=COUNT
// COUNT: {{^}}3{{$}}
// RUN: not ls %t.c
#include <cmath>
#include <cstdio>

// CHECK: once_a_place.cpp:[[@LINE+5]]:3: error: the program decides on a symbolic value: excess > 1.0 (met 5 times on 2 call paths, of which this is the shortest) [SYM016]
// CHECK: once_a_place.cpp:[[@LINE+4]]:3: note: recorded as
// CHECK-NEXT: once_a_place.cpp:[[@LINE+10]]:{{[0-9]+}}: note: called from f(double const*, double*)
static double limited(double value) {
  double excess = value - 3.0;
  if (excess > 1.0) return 2.0 * value;
  return value;
}
static double twice(double a) { return limited(a) + limited(a + 1); }

#pragma symreal function input(x[0:3]) output(y[0:2])
void f(double const *x, double *y) {
  y[0] = limited(x[0]);
  y[1] = twice(x[1]) + twice(x[2]);
  // CHECK: once_a_place.cpp:[[@LINE+3]]:{{[0-9]+}}: error: the program decides on a symbolic value: x[i] > 0.5 + i (met 3 times) [SYM016]
  // CHECK: note: recorded as x[0] > 0.5
  for (int i = 0; i < 3; ++i)
    if (x[i] > 0.5 + i) y[0] += 1;
  // CHECK: once_a_place.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of x[2] to int (met 1 time) [SYM016]
  switch ((int)x[2]) {
  case 1: y[1] += 1;
  }
}

int main() {
  double x[3] = {1, 2, 3}, y[2];
  f(x, y);
  std::printf("%g %g\n", y[0], y[1]);
}
