/* Jumps past declarations of arrays: g++ takes an array of a class that has constructors for initialised. */
// RUN: %rewrite %s -- | FileCheck %s
// RUN: %same %s --
// RUN: %rewrite %s -- > %t.rewritten.c && %rewrite %t.rewritten.c -- | diff %t.rewritten.c -
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// RUN: not %rewrite %s -- -DINITIALISED 2>&1 | FileCheck %s --check-prefix=INITIALISED
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>

static double f(int kind, double x)
{
    switch (kind) {
    case 0:
        x = 2 * x;
        // CHECK: REAL_EITHER((REAL a[2][2], s, *p), ::symreal::SymrealArray<REAL[2][2]> a; REAL s; REAL *p);
        double a[2][2], s, *p;
        for (int i = 0; i < 4; i++) a[i / 2][i % 2] = i * x;
        s = a[1][1];
        p = a[1];
        p[0] += sizeof(a);
        return s + *p;
    case 1:
        goto end;
        // CHECK: REAL_EITHER((REAL const b[2][2]), ::symreal::SymrealArray<REAL[2][2]> b; ::symreal::symreal_initialised(b.elements)) = {REAL_EITHER(([1] =), {}, ) {1, x}};
        double const b[2][2] = {[1] = {1, x}};
        return b[1][1] + b[0][1];
#ifdef INITIALISED
        // INITIALISED: jumps_past_arrays.c:[[@LINE+1]]:9: error: a jump passes the declaration of an array of REALs [SYM037]
        double c[2] = {1, x}, d = 2;
        return c[0] + d;
#endif
    default:
        break;
    }
    double t[3];
    t[0] = x;
    return t[0];
end:
    return 5 - x;
}

int main(void)
{
    double x = 0.5, y;
#pragma symreal input(x)
    y = f(0, x) + f(1, x) + f(2, x);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
