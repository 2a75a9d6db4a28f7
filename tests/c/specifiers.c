/* Declarations without a type, or with the word auto; structures that are defined where a function says what it returns. */
// RUN: %rewrite %s -- -std=gnu89 | FileCheck %s
// RUN: %same %s -- -std=gnu89 
// RUN: %rewrite %s -- -std=gnu89 > %t.rewritten.c && %rewrite %t.rewritten.c -- -std=gnu89 | diff %t.rewritten.c -
// RUN: %symreal generate %s -o %t.c -- -std=gnu89 && %symreal verify --samples=100 --min-samples=10 %s %t.c -- -std=gnu89  2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>

// CHECK: static REAL_ONLY(int) n;
static n;
// CHECK: const REAL_ONLY(int) limit = 3, *address = &limit;
const limit = 3, *address = &limit;
// CHECK: struct point { {{.*}} REAL x; int n; } REAL_ONLY(; struct point) point_of(REAL q)
struct point { double x; int n; } point_of(double q)
{
    struct point p;
    p.x = q;
    p.n = 2;
    return p;
}
// CHECK: REAL_EITHER((static const), ) struct pair {{.*}} } REAL_ONLY(; static const struct pair) *pair_of(void)
static const struct pair { double a, b; } *pair_of(void)
{
    static const struct pair pair = {3, 4};
    return &pair;
}
// CHECK: REAL_EITHER((static), ) enum side { LEFT, RIGHT } REAL_ONLY(; static enum side) side_of(int i)
static enum side { LEFT, RIGHT } side_of(int i) { return i ? LEFT : RIGHT; }
// CHECK: REAL_EITHER((static), ) struct REAL_ONLY(symreal_of_pack) {{.*}} } REAL_ONLY(; static struct symreal_of_pack) pack(void);
static struct { double v; } pack(void);

// CHECK: static REAL_ONLY(int) sign REAL_PROTOTYPE((REAL a), (a) REAL a;) {
static sign(a) double a; { return a > 0 ? 1 : -1; }
// CHECK: REAL_ONLY(int) two() { return 2; }
two() { return 2; }

static double f(double x)
{
    // CHECK: REAL_EITHER((auto), ) REAL s = x, t[2] = {x, 1};
    auto double s = x, t[2] = {x, 1};
    // CHECK: REAL_EITHER((auto), ) REAL_ONLY(int) k = 2;
    auto k = 2;
    int i = n + 1;
    return s * t[0] + k * i + limit + *address + point_of(x).x * point_of(x).n + pair_of()->b + side_of(0) + sign(2.0) +
           two();
}

int main(void)
{
    double x = 1.5, y;
#pragma symreal input(x) constant(address)
    y = f(x);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
