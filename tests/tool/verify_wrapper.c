/* `verify` tries the wrapper that lies beside a generated file: it hands over what the code computes, and changes
   nothing else. One of another kernel is refused. */
// RUN: rm -rf %t && mkdir %t && cp %s %t/v.c && cd %t && %symreal generate v.c -o . --wrapper --decisions=guard
// RUN: cd %t && %symreal verify v.c turn.c limited.c --samples=100 2>&1 | FileCheck %s
// CHECK: kernel turn, mode finite: 100 samples
// CHECK-NEXT: the wrapper was tried as well
// CHECK: kernel limited, mode finite: 100 samples
// CHECK: refused by a guard: {{[1-9]}}
// CHECK: the wrapper was tried as well
// RUN: sed 's/(s->a) = symreal_output/(s->b) = symreal_output/' %t/turn_wrapper.c > %t/w.c && not diff %t/w.c %t/turn_wrapper.c && mv %t/w.c %t/turn_wrapper.c
// RUN: cd %t && not %symreal verify v.c turn.c --samples=100 2>&1 | FileCheck %s --check-prefix=OTHER
// OTHER: turn_wrapper.c:1:1: error: this wrapper was generated for another form of kernel 'turn' [SYM090]
#include <stdio.h>

struct state { double a, b, c; };
static int calls;

#pragma symreal function input(s->a, s->b, angle[0:2]) output(s->a, return) scratch(calls)
double turn(struct state *s, double const angle[2])
{
    double const old = s->a;
    calls = 1;
    s->a = s->a * angle[0] - s->b * angle[1];
    return old + s->a;
}

#pragma symreal function input(x) output(y[0:2]) scratch(calls)
void limited(double x, double *y)
{
    calls = 1;
    y[0] = x > 1 ? 1 : x;
    y[1] = 2 * y[0];
}

int main(void)
{
    struct state s = {1, 2, 3};
    double angle[2] = {0.8, 0.6}, y[2];
    limited(0.5, y);
    printf("%g %g %g %d\n", turn(&s, angle), s.a, y[1], calls);
    return 0;
}
