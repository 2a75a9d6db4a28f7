/* Functions as they were declared before C89: C++ is told of their parameters. */
// RUN: %rewrite %s > %t.out && FileCheck %s < %t.out
// RUN: %same %s -- -std=gnu89
// RUN: rm -rf %t && mkdir %t && cp %s %t/old.c && cd %t && %symreal generate old.c -o k.c -- -std=gnu89 2> log && %symreal verify --samples=100 --min-samples=10 old.c k.c -- -std=gnu89
// RUN: cd %t && %symreal rewrite old.c --out-root once -- -std=gnu89 && cd once && %symreal rewrite old.c --diff -- -std=gnu89 | count 0
#include <stdio.h>

// CHECK: REAL sum REAL_PROTOTYPE((REAL x[], int n, REAL (*each)(REAL)), ());
double sum();
// CHECK: static int count REAL_PROTOTYPE((REAL REAL_NAME(this), char flag), ());
static int count();
double constant();

// CHECK: REAL half REAL_PROTOTYPE((REAL x), (x)
// CHECK-NEXT: REAL x;) { return x / 2; }
double half(x)
  double x; { return x / 2; }

/* CHECK: REAL kernel REAL_PROTOTYPE((REAL *a, REAL b), (a, b)
   CHECK-NEXT: REAL *a; /{{.}} of 3 {{.}}/
   CHECK-NEXT: register REAL b;)
   CHECK-NEXT: {{^}}{ SYMREAL_FUNCTION(
*/
#pragma symreal function input(a[0:3], b) output(return)
double kernel(a, b)
  double *a; /* of 3 */
  register double b;
{
  return sum(a, 3, half) * b + count(2.5, 'a') + constant();
}

// CHECK: REAL sum REAL_PROTOTYPE((REAL x[], int n, REAL (*each)(REAL)), (x, n, each) REAL x[]; int n; REAL (*each)(REAL);)
double sum(x, n, each) double x[]; int n; double (*each)(double);
{
  double total = 0;
  int i;
  for (i = 0; i < n; i++) total += each(x[i]);
  return total;
}
static int count(this, flag) double this; char flag; { return flag == 'a' && this > 2; }
double constant() { return 0.25; }

int main() {
  double a[3] = {1, 2, 3};
  printf("%g\n", kernel(a, 0.5));
  return 0;
}
