/* The reference of verify is the user's own text, in its own language and standard. Rewritten text is held against it, and
   so is what the original leaves in memory. What differs here does so by the switches of the three builds.
   RUN: %symreal generate %s -o %t.c -- -std=c89
   RUN: %symreal verify %s %t.c -- -std=c89 2>&1 | FileCheck %s --check-prefix=SAME
   RUN: not %symreal verify %s %t.c -- -std=c89 -DREWRITTEN_DIFFERS 2>&1 | FileCheck %s --check-prefix=REWRITTEN
   RUN: not %symreal verify %s %t.c -- -std=c89 -DORIGINAL_DIFFERS 2>&1 | FileCheck %s --check-prefix=ORIGINAL
   RUN: not %symreal verify %s %t.c -- -std=c89 -DLEAVES 2>&1 | FileCheck %s --check-prefix=LEFT
   RUN: not %symreal verify %s %t.c --json -- -std=c89 -DLEAVES | FileCheck %s --check-prefix=JSON
*/
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double last = 1;
double *cell;
char seen[8];
struct state { int calls; double gain; };

#if defined(MBD_REPLAY) && defined(REWRITTEN_DIFFERS)
#define FACTOR 3
#else
#define FACTOR 2
#endif

#pragma symreal function input(x[0:2], s->gain) output(y[0:2], return) constant(s->calls) scratch(s->calls)
double kernel(const double *x, struct state *s, double *y)
{
    double restrict = x[0]; /* a name that later standards have not */
    double class = x[1]; /* and one that C++ has not */
    y[0] = FACTOR * restrict * s->gain + class;
    y[1] = x[1] - 1;
#if defined(ORIGINAL_DIFFERS) && !defined(MBD_SYMBOLIC)
    y[1] += 1;
#endif
#if defined(LEAVES) && !defined(MBD_SYMBOLIC) && !defined(MBD_REPLAY)
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
    printf("%g\n", kernel(x, &s, y));
    return 0;
}

/* SAME: 1000 within the premises
   SAME: y[0] {{.*}} 0 {{ *}}0
   REWRITTEN: verify_original.c:[[@LINE-32]]:{{.*}}error: kernel 'kernel': 2 of 3 outputs of the rewritten program differ from the original's [SYM120]
   REWRITTEN: note: value_return: original {{.*}}, rewritten {{.*}} inputs
   ORIGINAL: error: 2 of 3 outputs differ from the original [SYM091]
   ORIGINAL: note: value_return: original {{.*}}, generated
   LEFT: error: kernel 'kernel': the original leaves 'last' changed, on {{[0-9]+}} samples [SYM121]
   LEFT-DAG: note: the original leaves 'seen' changed
   LEFT-DAG: note: the original leaves a block of 8 bytes on the heap changed
   LEFT-DAG: note: the original leaves a variable of a calling function changed
   JSON: "left_behind": [
   JSON: "name": "'last'"
*/
