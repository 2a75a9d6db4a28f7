/* Of several kernels without a wrapper each is reported at its place, and nothing is written.
   RUN: rm -rf %t && mkdir %t && cd %t
   RUN: not %symreal generate %s -o out --wrapper > log 2>&1 && FileCheck %s --implicit-check-not=error: < log && not ls out
   CHECK-DAG: wrapper_refused_several.c:[[# @LINE+15]]:1: error: --wrapper cannot return what 'unread' returns, which is not an output: add output(return) [SYM095]
   CHECK-DAG: wrapper_refused_several.c:[[# @LINE+20]]:{{[0-9]+}}: error: --wrapper cannot compare 'of' of 'called', which is baked in: {{.*}} [SYM095]
   CHECK-DAG: wrapper_refused_several.c:[[# @LINE+32]]:{{[0-9]+}}: error: --wrapper needs a function: kernel 'block' is a stretch of code without a signature [SYM095]

   Their copies, where these do not compile, as well: a variable has the name of a generated function.
   RUN: cd %t && not %symreal generate %s -o out --wrapper -- -DIN_COPIES > log 2>&1 && FileCheck %s --check-prefix=COPIES --implicit-check-not=error: < log && not ls out
   COPIES-DAG: error: the wrapper of 'first' does not compile: {{.*}} [SYM095]
   COPIES-DAG: error: the wrapper of 'second' does not compile: {{.*}} [SYM095]
*/
#include <stdio.h>

double twice(double x);
double twice(double x) { return 2 * x; }

#ifndef IN_COPIES
#pragma symreal function input(x) output(*y)
double unread(double x, double *y) {
  *y = x * x;
  return *y + 1;
}

#pragma symreal function input(x) output(return)
double called(double x, double (*of)(double)) { return of(x) * x; }

#pragma symreal function input(x) output(return)
double right(double x) { return x * x; }

int main(void) {
  double y, z = 2;
  unread(2, &y);
  printf("%g ", called(3, twice));
  printf("%g ", right(4));
#pragma symreal input(z)
  y = z * z;
#pragma symreal output(y) generate("block.c")
  printf("%g\n", y);
  return 0;
}
#else
static int first_compute, second_compute;

#pragma symreal function input(x) output(return)
static double first(double x) { return x * 3; }

#pragma symreal function input(x) output(return)
static double second(double x) { return x * 4; }

#pragma symreal function input(x) output(return)
static double third(double x) { return x * 5; }

int main(void) {
  printf("%g %g %g %d\n", first(1), second(2), third(3), first_compute + second_compute);
  return 0;
}
#endif
