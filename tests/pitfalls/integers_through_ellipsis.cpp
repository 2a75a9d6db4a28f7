// A function of the program may compute with the integer that it takes through `...`: it is a decision there, on the
// value of the type that arrives. What a library prints needs none.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
// RUN: %symreal generate %s --decisions=guard -o %t.c 2>&1 | FileCheck %s --check-prefix=GUARD
// RUN: %symreal verify %s %t.c --samples=500 --min-samples=5
// RUN: %cxx %s -o %t.original && %symreal-c++ %s -o %t.symbolic && %t.original > %t.expected
// RUN: env SYMREAL_REQUEST=decisions=guard %t.symbolic | diff %t.expected -
#include <cstdarg>
#include <cstdio>

static int pick(int which, ...) {
  va_list list;
  va_start(list, which);
  int value = 0;
  for (int i = 0; i < which; ++i) value = 10 * value + va_arg(list, int);
  va_end(list);
  return value;
}
static long last(char const *kinds, ...) {
  va_list list;
  va_start(list, kinds);
  long value = 0;
  for (; *kinds; ++kinds) value = *kinds == 'l' ? va_arg(list, long) : va_arg(list, int);
  va_end(list);
  return value;
}

#pragma symreal function input(x) range(0, 9) output(return)
double kernel(double x) {
  long const big = (long)x * 3000000000;
  short const s = (short)((int)x * 9000);
  printf("%d %ld\n", (int)x, big);
  // CHECK-DAG: integers_through_ellipsis.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of x
  double y = x + pick(2, (int)x, 3);
  // CHECK-DAG: integers_through_ellipsis.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of
  y += last("il", 1, big);
  // CHECK-DAG: integers_through_ellipsis.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of
  return y + last("i", s);
}
// GUARD: guard 1 {{.*}}: the conversion of x gives 5

int main() { printf("%.17g\n", kernel(5.3)); }
