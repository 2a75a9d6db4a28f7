/* A macro's `?:` between an integer and a choice that becomes a select: the choice is made plain, by a decision.
   RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
   CHECK: choices_in_macros.c:[[#@LINE+12]]:{{[0-9]+}}: error: the program decides on a symbolic value: {{.*}}[SYM016]
   CHECK-NOT: SYM005
   RUN: rm -rf %t && %symreal generate %s -o %t/ --decisions=auto && %symreal verify %s %t/element.c %t/signs.c %t/joined.c --samples=400 --min-samples=20
*/
#include <math.h>
#include <stdio.h>
#define MAX(a, b) ((a) > (b) ? (a) : (b))
#define SIGN(a) ((a) > 0 ? 1 : (a) < 0 ? -1 : 0)

#pragma symreal function input(x, t[0:4]) output(return)
double element(double x, double const *t) {
  int i = (int)floor(x);
  return t[MAX(i < 2 ? i : 3, 0)] + x;
}

#pragma symreal function input(x, y) output(return)
double signs(double x, double y) {
  int i = 1, j = 2, k = MAX(x > 0 ? i : j, 0);
  return x * MAX(SIGN(y), 0) + SIGN(SIGN(x)) * k;
}

#pragma symreal function input(x, y) output(return)
double joined(double x, double y) {
  int n = (int)floor(y);
  return MAX(MAX(x > y ? n : 2, 1), x > 0 ? 3 : n) * x;
}

int main(void) {
  double const t[4] = {1, 2, 3, 4};
  printf("%g %g %g\n", element(1.5, t), signs(1, 2), joined(1, 2.5));
  return 0;
}
