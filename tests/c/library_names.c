/* Functions, variables and types of the program that have names of the C library, as C alone allows it. */
// RUN: %rewrite %s -- -std=c99 | FileCheck %s
// RUN: %same %s -- -std=c99 
// RUN: %rewrite %s -- -std=c99 > %t.rewritten.c && %rewrite %t.rewritten.c -- -std=c99 | diff %t.rewritten.c -
// RUN: %symreal generate %s -o %t.c -- -std=c99 && %symreal verify --samples=100 --min-samples=10 %s %t.c -- -std=c99  2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
// RUN: not %symreal generate %s -o %t.none.c -- -std=c99 -DREAD 2>&1 | FileCheck %s --check-prefix=READ
// RUN: not %rewrite %s -- -DLIBRARY 2>&1 | FileCheck %s --check-prefix=LIBRARY
#include <math.h>
#include <stdio.h>

#ifdef LIBRARY
#define _GNU_SOURCE
// LIBRARY: library_names.c:[[@LINE+2]]:8: error: 'y1' is a function of the C library, which a header declares and the program defines itself [SYM037]
#endif
double y1(double a) { return 2 * a; }
#ifndef LIBRARY
// CHECK: static const REAL REAL_NAME(j0) = 3, REAL_NAME(index)[2] = {1, 2};
static const double j0 = 3, index[2] = {1, 2};
// CHECK: REAL REAL_NAME(gamma)(REAL a, REAL b);
double gamma(double a, double b);
#ifdef READ
// READ: error: kernel 'y' reads 'gammaf' (2), which is neither input nor parameter
static double gammaf = 2;
#else
enum { gammaf = 2 };
#endif
// CHECK: typedef struct { REAL v; } REAL_NAME(link);
typedef struct { double v; } link;
// CHECK: enum { REAL_NAME(pipe) = 4 };
enum { pipe = 4 };
double gamma(double a, double b) { return a * b; }
static int select(double a) { return a > 0 ? 1 : 2; }
// What is only declared is the library's.
// CHECK: extern int toupper(int c);
extern int toupper(int c);
struct point { double j0, index; };

static double f(double x)
{
    // CHECK: REAL_NAME(link) k = {x}, *l = &k;
    link k = {x}, *l = &k;
    struct point p = {1, x};
    double yn = 2;
    // CHECK: return REAL_NAME(y1)(x) + {{.*}}REAL_NAME(j0)
    return y1(x) + j0 + gamma(x, 3) + yn + gammaf + l->v * pipe + index[1] + select(2.0) + p.j0 + p.index + toupper('a');
}

int main(void)
{
    double x = 1.5, y;
#pragma symreal input(x)
    y = f(x);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
#endif
