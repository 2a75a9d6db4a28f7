/* A wrapper compares whether an output lies where another argument does: the original then writes what it has yet to read.
   RUN: rm -rf %t && mkdir %t && cd %t
   DEFINE: %{c} = %cc -std=c99 -Wall -Wextra -pedantic -Werror -Wno-unknown-pragmas
   RUN: cd %t && %symreal generate %s -o ./ --wrapper
   RUN: cd %t && %symreal verify %s pointers.c results.c members.c rows.c apart.c --samples=20 --min-samples=5 2>&1 | FileCheck %s
   CHECK: kernel pointers
   CHECK-NEXT: the wrapper was tried as well
   CHECK: kernel results
   CHECK-NEXT: the wrapper was tried as well
   CHECK: kernel members
   CHECK-NEXT: the wrapper was tried as well
   CHECK: kernel rows
   CHECK-NEXT: the wrapper was tried as well
   CHECK: kernel apart
   CHECK-NEXT: the wrapper was tried as well
   RUN: cd %t && %{c} %s -lm -o original && ./original > expected
   RUN: cd %t && %{c} pointers.c results.c members.c rows.c apart.c pointers_wrapper.c -lm -o swapped && ./swapped | diff expected -
   RUN: FileCheck %s --check-prefix=POINTERS < %t/pointers_wrapper.c
   POINTERS: if (symreal_apart(&(x)[(0) + 0], &(x)[(0) + 2] + 1, &(y)[(0) + 0], &(y)[(0) + 2] + 1) != 9223372036854775808ull) symreal_same = 0;
   Pointers that promise to be apart are not compared, nor are values and variables.
   RUN: cd %t && %symreal generate %s --kernel apart -o a.c --wrapper && not grep "^static.*symreal_apart" a_wrapper.c
   RUN: cd %t && %{c} a.c a_wrapper.c -lm -o swapped && ./swapped | diff expected -
   A file of its own has no original to call.
   RUN: cd %t && %symreal generate %s --kernel pointers -o k.c --wrapper -- -DOUTSIDE && %{c} -DOUTSIDE -DCALLER %s k.c k_wrapper.c -lm -o swapped
   RUN: cd %t && not --crash ./swapped 2>&1 | FileCheck %s --check-prefix=REFUSED
   REFUSED: where 'x[0:3]' and 'y[0:3]' lie: this call has another value than the generated code
*/
#include <math.h>
#include <stdio.h>

#ifdef OUTSIDE
#define LINKAGE
#else
#define LINKAGE static
#endif

#ifdef CALLER
void pointers(double const *x, double *y);
#else
#pragma symreal function input(x[0:3]) output(y[0:3])
LINKAGE void pointers(double const *x, double *y)
{
  int k;
  for (k = 0; k < 3; ++k) y[k] = 2 * x[(k + 1) % 3] + x[0];
}
#endif
static void call_pointers(double *a, double *b)
{
  pointers(a, b);
  pointers(a, a);
  pointers(a, a + 1);
  pointers(b + 2, b);
}

#pragma symreal function input(x) output(*sine, *cosine)
static void results(double x, double *sine, double *cosine)
{
  *cosine = cos(x);
  *sine = sin(x);
}
static void call_results(double *a, double *b)
{
  results(a[0], a, b);
  results(a[1], a, a);
  results(a[2], b, b);
}

struct filter {
  double gain[2], *in, *out;
};
#pragma symreal function input(f->in[0:2], f->gain) output(f->out[0:2])
static void members(struct filter *f)
{
  f->out[0] = f->in[1] * f->gain[0];
  f->out[1] = f->in[0] + f->in[1] * f->gain[1];
}
static void call_members(double *a, double *b)
{
  struct filter f = {{2, 3}, 0, 0};
  f.in = a;
  f.out = b;
  members(&f);
  f.out = a;
  members(&f);
  f.out = f.gain;
  members(&f);
  a[2] = f.gain[0] + f.gain[1];
}

#pragma symreal function input(m[0:2][0:2]) output(y[0:2])
static void rows(double **m, double *y)
{
  y[0] = m[0][1] + m[1][1];
  y[1] = m[0][0] * m[1][0] + m[0][1];
}
static void call_rows(double *a, double *b)
{
  double *both[2];
  both[0] = a;
  both[1] = a + 2;
  rows(both, b);
  rows(both, a);
}

static double state[2];
#pragma symreal function input(x[0:2], gain, state) output(y[0:2], state)
static void apart(double const *restrict x, double gain, double *restrict y)
{
  y[0] = gain * x[1];
  y[1] = x[0] + state[0];
  state[0] = gain;
  state[1] += gain;
}
static void call_apart(double *a, double *b) { apart(a, 2, b); }

static void (*const calls[5])(double *, double *) = {call_pointers, call_results, call_members, call_rows, call_apart};

int main(void)
{
  int k, i;
  for (i = 0; i < 5; ++i) {
    double a[5] = {1, 2, 3, 4, 5}, b[5] = {6, 7, 8, 9, 10};
    calls[i](a, b);
    for (k = 0; k < 5; ++k) printf("%.17g %.17g\n", a[k], b[k]);
  }
  return 0;
}
