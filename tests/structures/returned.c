/* A function that takes a structure and returns one, in C and as C++.
   RUN: %symreal generate %s -o %t.c
   RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
   RUN: cp %s %t.cpp && %symreal generate %t.cpp -o %t.2.c && %symreal verify --samples=100 --min-samples=10 %t.cpp %t.2.c 2>&1 | FileCheck %s
   RUN: grep -v include %t.c > %t.code && grep -v include %t.2.c | diff %t.code -
*/
#include <stdio.h>

typedef struct { double position, velocity; int steps; } state;

#pragma symreal function input(s, h) output(return)
state step(state s, double const h)
{
    state next = s;
    next.position += h * s.velocity * s.steps;
    if (s.steps == 0) return s;
    next.velocity -= h * s.position;
    return next;
}

int main(void)
{
    state s = {1, 0.5, 3};
    s = step(s, 0.125);
    printf("%g %g\n", s.position, s.velocity);
    return 0;
}

/* CHECK: 100 within the premises
   CHECK: value_return.{{.*}} 2 {{ *}}0 {{ *}}0
*/
