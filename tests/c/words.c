/* Words of C that C++ does not have, and names that it has taken for words. */
// RUN: %symreal generate %s -o %t.c && FileCheck %s --input-file=%t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c
// CHECK: input[0]*input[1]
// CHECK: 8.0
#include <stdio.h>
#include <stdlib.h>

static _Thread_local double kept[2];
static __thread double old;
_Static_assert(sizeof(double) == 8, "as everywhere");

static double dot(double const *restrict a, double const b[restrict 2]) { return a[0] * b[0] + a[1] * b[1]; }
static _Noreturn void leave(void) { exit(1); }

#pragma symreal function input(x[0:4]) output(y[0:2]) scratch(kept, old)
void kernel(double const *restrict x, double *restrict y)
{
    _Alignas(16) double near[2];
    int char8_t = 3;
    if (x == 0) leave();
    kept[0] = x[0] * x[1];
    old = kept[0] + x[2];
    near[0] = dot(x, x + 2);
    y[0] = kept[0] + old + char8_t * near[0];
    y[1] = x[3] * _Alignof(double) + _Alignof(char);
}

int main(void)
{
    double x[4] = {1.5, 2.5, 0.25, 3.5}, y[2];
    kernel(x, y);
    printf("%g %g\n", y[0], y[1]);
    return 0;
}
