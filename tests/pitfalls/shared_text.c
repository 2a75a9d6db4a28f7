/* Text that is compiled several times, with other types each time: a conversion goes by what it is for. */
// RUN: rm -rf %t && mkdir %t && cp -r %s %S/Inputs %t
// RUN: cd %t && %symreal rewrite --out-root new shared_text.c && cat new/shared_text.c new/Inputs/shared_text.h > new/all && FileCheck %s < new/all
// RUN: %same %s
// RUN: cd %t && %cc -DNO_KERNEL shared_text.c -o plain.exe -lm && %symreal-cc -DNO_KERNEL shared_text.c -o traced.exe -lm && ./plain.exe > plain && ./traced.exe > traced && diff plain traced
// RUN: cd %t && %symreal generate shared_text.c -o y.c && %symreal verify --samples=100 --min-samples=10 shared_text.c y.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define PREFIX with_double
#define BASE double
#include "Inputs/shared_text.h"
#undef PREFIX
#undef BASE
#define PREFIX with_float
#define BASE float
#include "Inputs/shared_text.h"

// CHECK: #define PUT(target) target = REAL_FIT(x * 2)
#define PUT(target) target = x * 2
#define BOTH(one, other, what) one = what; other = what
// What is read at a symbolic index, and written besides, is no table.
// CHECK: #define AT(a, i) REAL_READ({{.*}}, REAL_WRITTEN({{.*}}, (a)[(i) % 4]))
#define AT(a, i) (a)[(i) % 4]
// CHECK: #define OF(a, i) REAL_TABLE("(a)", {{.*}}, (a))[i]
#define OF(a, i) (a)[i]

static double at(double x)
{
    double a[4];
    static double const table[3] = {1, 2, 4};
    int i;
    for (i = 0; i < 4; ++i) AT(a, i) = i * x;
    i = x;
    AT(a, 3) += 1;
    return AT(a, i) + OF(table, i);
}

/* Operands of comparisons and arms have no context. */
#define SAME(one, other) ((one) == (other) || (one) == NULL)
#define EITHER(which, one, other) ((which) ? (one) : (other))
static int pointers(double *x, const double *y, void *z, int *k)
{
    const void *either = EITHER(*k, x, z);
    const double *both = EITHER(*k, x, y);
    return SAME(x, y) + SAME(z, y) + SAME(both, x) + SAME((double *)either, y) + SAME(k, z);
}

static double put(double x)
{
    int i, k;
    double y, z;
    PUT(i);
    PUT(y);
    // CHECK: BOTH(k, z, REAL_FIT(x * 3));
    BOTH(k, z, x * 3);
    return y + i + k + z;
}

// CHECK: if (copy == NULL) return;
// CHECK: = REAL_FIT(x / 3);
// CHECK: += sin(REAL_PROMOTED(
int main(void)
{
    double x = 1.3, y = 0;
    float z = 0;
    int which = 3;
#ifdef NO_KERNEL
    with_float_third(x, &z);
    y += put(x) + at(x) + pointers(&x, &y, &z, &which);
    printf("%.17g %.17g\n", y, z);
#endif
#pragma symreal input(x) range(1.3, 1.4)
    with_double_third(x, &y);
#pragma symreal output(y) generate("y.c")
    printf("%.17g %.17g\n", y, z);
    return 0;
}
