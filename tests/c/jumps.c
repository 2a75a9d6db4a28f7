/* A jump passes initialisations, which C++ does not allow: they become assignments. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %rewrite %s > %t.rewritten.c && %rewrite %t.rewritten.c | diff %t.rewritten.c -
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
// RUN: not %symreal generate %s -o %t.none.c -- -DNAMELESS 2>&1 | FileCheck %s --check-prefix=NAMELESS
#include <stdio.h>

struct pair { double a, b; };

static double select_one(int kind, double x, double const *t)
{
    switch (kind) {
    case 0:;
        // CHECK: REAL a REAL_ONLY(; ::symreal::symreal_initialised(a)) = x REAL_EITHER((,), ; REAL) *p REAL_ONLY(; ::symreal::symreal_initialised(p)) = &a REAL_EITHER((,), ; REAL) c;
        double a = x, *p = &a, c;
        c = *p;
        return a * c;
    case 1:;
        // CHECK: REAL_EITHER((const), ) REAL k REAL_ONLY(; ::symreal::symreal_initialised(k)) = {{.*}}t[0]) + x;
        const double k = t[0] + x;
        // CHECK: REAL const *REAL_EITHER((const), ) q REAL_ONLY(; ::symreal::symreal_initialised(q)) = t;
        double const *const q = t;
        return k + q[1];
    case 2:;
        // CHECK: int r[2][2] REAL_ONLY(; ::symreal::symreal_initialised(r)) = {
        int r[2][2] = {{1, 2}, {3}};
        // CHECK: struct pair s REAL_ONLY(; ::symreal::symreal_initialised(s)) = {
        struct pair s = {x, 3};
        // CHECK: struct pair u REAL_ONLY(; ::symreal::symreal_initialised(u)) = s;
        struct pair u = s;
        // CHECK: static int calls = 0;
        static int calls = 0;
        if (calls) return 0;
        return r[0][1] + r[1][0] + r[1][1] + s.a * u.b;
#ifdef NAMELESS
    case 3:;
        // NAMELESS: jumps.c:[[#@LINE+1]]:36: error: a jump passes the initialisation of 'one'
        struct { double v; } zero, one = {1}, two = {2};
        return zero.v + one.v + two.v;
#endif
    default:
        return 0;
    }
}

static double leave_early(double x, int n)
{
    double y = 0;
    if (n < 0) goto done;
    // CHECK: int m REAL_ONLY(; ::symreal::symreal_initialised(m)) = n * 2;
    int m = n * 2;
    y = m * x;
done:
    return y;
}

static double loop(double x)
{
    int n = 0;
again:; // nothing is passed on the way back
    // CHECK: {{^    }}REAL y = x * n;
    double y = x * n;
    if (++n < 3) goto again;
    return y;
}

int main(void)
{
    double x = 1.5, y, t[2] = {0.25, 4};
#pragma symreal input(x)
#pragma symreal constant(t)
    y = select_one(0, x, t) + 2 * select_one(1, x, t) + 3 * select_one(2, x, t) + select_one(7, x, t);
    y += leave_early(x, 3) + leave_early(x, -1) + loop(x);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
