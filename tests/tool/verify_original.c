/* The reference of verify is the user's own text, in its own language and standard. Rewritten text is held against it, and
   so is what the original leaves in memory. What differs here does so by the macros of the three builds.
   RUN: rm -rf %t && mkdir %t
   RUN: cd %t && %symreal generate %s -o ./ -- -std=c89
   RUN: cd %t && %symreal verify %s same.c --samples=100 -- -std=c89 2>&1 | FileCheck %s --check-prefix=SAME
   RUN: cd %t && not %symreal verify %s rewritten.c original.c left.c --samples=100 --min-samples=10 --json -- -std=c89 > json 2> told
   RUN: FileCheck %s --implicit-check-not=error: < %t/told
   RUN: FileCheck %s --check-prefix=JSON < %t/json
*/
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double last = 1;
double *cell;
char seen[8];
struct state { int calls; double gain; };

#pragma symreal function input(x[0:2], s->gain) output(y[0:2], return) constant(s->calls) scratch(s->calls)
double same(const double *x, struct state *s, double *y)
{
    double restrict = x[0]; /* a name that later standards have not */
    double class = x[1]; /* and one that C++ has not */
    y[0] = 2 * restrict * s->gain + class;
    y[1] = x[1] - 1;
    s->calls++;
    return y[0] + y[1];
}

#ifdef MBD_REPLAY
#define FACTOR 3
#else
#define FACTOR 2
#endif
#pragma symreal function input(x[0:2], s->gain) output(y[0:2], return) constant(s->calls) scratch(s->calls)
double rewritten(const double *x, struct state *s, double *y)
{
    y[0] = FACTOR * x[0] * s->gain + x[1];
    y[1] = x[1] - 1;
    s->calls++;
    return y[0] + y[1];
}

#pragma symreal function input(x[0:2], s->gain) output(y[0:2], return) constant(s->calls) scratch(s->calls)
double original(const double *x, struct state *s, double *y)
{
    y[0] = 2 * x[0] * s->gain + x[1];
    y[1] = x[1] - 1;
#ifndef MBD_SYMBOLIC
    y[1] += 1;
#endif
    s->calls++;
    return y[0] + y[1];
}

#pragma symreal function input(x[0:2], s->gain) output(y[0:2], return) constant(s->calls) scratch(s->calls)
double left(const double *x, struct state *s, double *y)
{
    y[0] = 2 * x[0] * s->gain + x[1];
    y[1] = x[1] - 1;
#if !defined(MBD_SYMBOLIC) && !defined(MBD_REPLAY)
    last = x[0];
    *cell = 2;
    strcpy(seen, "here");
    s->gain *= 1.5;
#endif
    s->calls++;
    return y[0] + y[1];
}

int main(void)
{
    double x[2] = {5.5, 2}, y[2];
    struct state s = {0, 0.5};
    cell = (double *)malloc(sizeof *cell);
    *cell = 1;
    printf("%g\n", same(x, &s, y) + rewritten(x, &s, y) + original(x, &s, y) + left(x, &s, y));
    return 0;
}

/* SAME: 100 within the premises
   SAME: y[0] {{.*}} 0 {{ *}}0
   CHECK: verify_original.c:[[@LINE-48]]:{{.*}}error: kernel 'rewritten': 2 of 3 outputs of the rewritten program differ from the original's [SYM120]
   CHECK: note: value_return: original {{.*}}, rewritten {{.*}} inputs
   CHECK: error: 2 of 3 outputs differ from the original [SYM091]
   CHECK: note: value_return: original {{.*}}, generated
   CHECK: error: kernel 'left': the original leaves 'last' changed, on {{[0-9]+}} samples [SYM121]
   CHECK-DAG: note: the original leaves 'seen' changed
   CHECK-DAG: note: the original leaves a block of 8 bytes on the heap changed
   CHECK-DAG: note: the original leaves a variable of a calling function changed
   JSON: "left_behind": [
   JSON: "name": "'last'"
*/
