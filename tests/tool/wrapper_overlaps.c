/* A wrapper compares whether an output lies where another argument does: the original then writes what it has yet to read.
   RUN: rm -rf %t && mkdir %t && cd %t
   DEFINE: %{kernel} =
   DEFINE: %{c} = %cc -std=c99 -Wall -Wextra -pedantic -Werror -Wno-unknown-pragmas -D%{kernel}
   DEFINE: %{try} = cd %t && %symreal generate %s -o k.c --wrapper -- -D%{kernel} && %{c} k.c k_wrapper.c -lm -o swapped && %{c} %s -lm -o original && ./original > expected && ./swapped | diff - expected && %symreal verify %s k.c --samples=20 --min-samples=5 -- -D%{kernel} 2>&1 | FileCheck %s
   CHECK: the wrapper was tried as well
   REDEFINE: %{kernel} = POINTERS
   RUN: %{try} && FileCheck %s --check-prefix=POINTERS < k_wrapper.c
   POINTERS: if (symreal_apart(&(x)[(0) + 0], &(x)[(0) + 2] + 1, &(y)[(0) + 0], &(y)[(0) + 2] + 1) != 9223372036854775808ull) symreal_same = 0;
   REDEFINE: %{kernel} = RESULTS
   RUN: %{try}
   REDEFINE: %{kernel} = MEMBERS
   RUN: %{try}
   REDEFINE: %{kernel} = ROWS
   RUN: %{try}
   Pointers that promise to be apart are not compared, nor are values and variables.
   REDEFINE: %{kernel} = APART
   RUN: %{try} && not grep "^static.*symreal_apart" k_wrapper.c
   A file of its own has no original to call.
   RUN: cd %t && %symreal generate %s -o k.c --wrapper -- -DPOINTERS -DOUTSIDE && %{c} -DPOINTERS -DOUTSIDE -DCALLER %s k.c k_wrapper.c -o swapped
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

#if defined(POINTERS)
#ifdef CALLER
void kern(double const *x, double *y);
#else
#pragma symreal function input(x[0:3]) output(y[0:3])
LINKAGE void kern(double const *x, double *y)
{
  int k;
  for (k = 0; k < 3; ++k) y[k] = 2 * x[(k + 1) % 3] + x[0];
}
#endif
static void calls(double *a, double *b)
{
  kern(a, b);
  kern(a, a);
  kern(a, a + 1);
  kern(b + 2, b);
}

#elif defined(RESULTS)
#pragma symreal function input(x) output(*sine, *cosine)
LINKAGE void kern(double x, double *sine, double *cosine)
{
  *cosine = cos(x);
  *sine = sin(x);
}
static void calls(double *a, double *b)
{
  kern(a[0], a, b);
  kern(a[1], a, a);
  kern(a[2], b, b);
}

#elif defined(MEMBERS)
struct filter {
  double gain[2], *in, *out;
};
#pragma symreal function input(f->in[0:2], f->gain) output(f->out[0:2])
LINKAGE void kern(struct filter *f)
{
  f->out[0] = f->in[1] * f->gain[0];
  f->out[1] = f->in[0] + f->in[1] * f->gain[1];
}
static void calls(double *a, double *b)
{
  struct filter f = {{2, 3}, 0, 0};
  f.in = a;
  f.out = b;
  kern(&f);
  f.out = a;
  kern(&f);
  f.out = f.gain;
  kern(&f);
  a[2] = f.gain[0] + f.gain[1];
}

#elif defined(ROWS)
#pragma symreal function input(m[0:2][0:2]) output(y[0:2])
LINKAGE void kern(double **m, double *y)
{
  y[0] = m[0][1] + m[1][1];
  y[1] = m[0][0] * m[1][0] + m[0][1];
}
static void calls(double *a, double *b)
{
  double *rows[2];
  rows[0] = a;
  rows[1] = a + 2;
  kern(rows, b);
  kern(rows, a);
}

#else
static double state[2];
#pragma symreal function input(x[0:2], gain, state) output(y[0:2], state)
LINKAGE void kern(double const *restrict x, double gain, double *restrict y)
{
  y[0] = gain * x[1];
  y[1] = x[0] + state[0];
  state[0] = gain;
  state[1] += gain;
}
static void calls(double *a, double *b) { kern(a, 2, b); }
#endif

int main(void)
{
  double a[5] = {1, 2, 3, 4, 5}, b[5] = {6, 7, 8, 9, 10};
  int k;
  calls(a, b);
  for (k = 0; k < 5; ++k) printf("%.17g %.17g\n", a[k], b[k]);
  return 0;
}
