/* C has int for a comparison, a truth value and a character, whatever stands for a number: in _Generic, __typeof__,
   __auto_type, and in what gcc asks about types. */
// RUN: %same %s -- -std=gnu11
// RUN: %rewrite %s -- -std=gnu11 > %t.rewritten.c && %rewrite %t.rewritten.c -- -std=gnu11 | diff %t.rewritten.c -
// RUN: %symreal generate %s --decisions=guard -o %t.c -- -std=gnu11
// RUN: %symreal verify %s %t.c --samples=100 --min-samples=5 -- -std=gnu11
// RUN: grep -v "pragma symreal" %s > %t.plain.c
// RUN: %cc -std=gnu11 %t.plain.c -o %t.original && %symreal-cc -std=gnu11 %t.plain.c -o %t.symbolic
// RUN: %t.original > %t.expected && %t.symbolic | diff %t.expected -
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#define KIND(x) _Generic((x), _Bool: 1, char: 2, short: 3, int: 4, unsigned: 5, long: 6, unsigned long: 7, double: 8, \
                         char *: 9, char const *: 10, int *: 11, double const *: 12, void *: 13, default: 14)

enum level { LOW, HIGH };
static double twice(double x) { return 2 * x; }
static int next(int n) { return n + 1; }
#define CALL(x) _Generic((x), double: twice, int: next)(x)
#define MAX(a, b) ({ __typeof__(a) a_ = (a); __typeof__(b) b_ = (b); a_ > b_ ? a_ : b_; })

#pragma symreal function input(x[0:2]) range(0.5, 3) output(y[0:6])
void kernel(double const *x, double *y)
{
    int const i = (int)(4 * x[0]);
    short s = (short)x[1];
    long l = (long)x[1];
    _Bool flag = 1;
    enum level level = HIGH;
    y[0] = x[0] * KIND(x[0] > 1) + 100 * KIND(!x[0]) + 1e4 * KIND(x[0] > 1 && x[1] > 1) + 1e6 * KIND((x[0] > 1) + 1) +
           1e8 * KIND(-(x[0] < x[1])) + 1e10 * KIND(x[0] > 1 ? 1 : 2) + 1e12 * KIND(x[0] > 1 ? x[0] : 2);
    y[1] = x[0] * KIND(i) + 100 * KIND((int)x[0]) + 1e4 * KIND(s) + 1e6 * KIND(+s) + 1e8 * KIND(l * i) + 1e10 * KIND(&i) +
           1e12 * KIND((short)x[0]);
    y[2] = x[0] * KIND(1 > 2) + 100 * KIND(flag) + 1e4 * KIND(level) + 1e6 * KIND(LOW) + 1e8 * KIND('c') +
           1e10 * KIND("abc") + 1e12 * KIND(NULL);
    __typeof__(x[0] > 1) counter = x[0] > 1;
    y[3] = x[0] * counter;
    counter = 5;
    __auto_type also = x[1] > 1;
    also = 7;
    __auto_type more = i + 2;
    y[3] += counter + also * x[1] + more + sizeof counter + sizeof also + sizeof more + sizeof(x[0] > 1) + KIND(also);
    y[4] = CALL(x[0]) + CALL(x[0] > x[1]) + MAX(x[0], x[1]) + MAX(i, 3);
    y[5] = x[0] * __builtin_types_compatible_p(__typeof__(x[0] > 1), int) +
           10 * __builtin_types_compatible_p(__typeof__(x[0]), double const) +
           100 * __builtin_types_compatible_p(__typeof__(i), int) +
           1000 * __builtin_types_compatible_p(int[], int[3]) + 1e4 * __builtin_types_compatible_p(enum level, long) +
           1e5 * __builtin_choose_expr(sizeof(x[0] > 1) == sizeof(int), x[1], "wrong") +
           1e6 * KIND(signbit(x[0])) + 1e8 * KIND(isnan(x[1])) + 1e10 * KIND(lround(x[0]));
}

int main(void)
{
    double x[2] = {1.25, 0.75}, y[6];
    kernel(x, y);
    for (int k = 0; k < 6; k++) printf("%.17g\n", y[k]);
    return 0;
}
