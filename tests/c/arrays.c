/* Arrays of characters without a zero behind them, and parameters that say how long they are. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s 
// RUN: %rewrite %s > %t.rewritten.c && %rewrite %t.rewritten.c | diff %t.rewritten.c -
// RUN: %symreal generate %s --decisions=guard -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c  2>&1 | FileCheck %s --check-prefix=SAME
// RUN: not %rewrite %s -- -DSIZE 2>&1 | FileCheck %s --check-prefix=SIZE
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>

#define MAGIC "GIF"
// CHECK: static const char magic[3] = REAL_EITHER((MAGIC), {71, 73, 70}), *name = MAGIC;
static const char magic[3] = MAGIC, *name = MAGIC;
// CHECK: static char rows[][2] = {REAL_EITHER(("ab"), {97, 98}), REAL_EITHER(("c" "\xff"), {99, -1}), "d"};
static char rows[][2] = {"ab", "c" "\xff", "d"};
// CHECK: static unsigned char bytes[2] = {REAL_EITHER(("\xfe\x01"), 254, 1)};
static unsigned char bytes[2] = {"\xfe\x01"};
struct named { char name[2]; double value; };

// CHECK: static REAL first(int n, REAL a[REAL_EITHER((n), )], REAL b[REAL_EITHER((static 1), )], REAL c[REAL_EITHER((const restrict), )])
static double first(int n, double a[n], double b[static 1], double c[const restrict])
{
    return a[n - 1] + b[0] * c[1];
}

// CHECK: REAL corner(int n, REAL_EITHER((const REAL a[*][*]), void const *symreal_a), REAL [REAL_EITHER((*), )]);
double corner(int n, const double a[*][*], double [*]);
// CHECK: REAL corner(int n, REAL_EITHER((const REAL a[n][n]), void const *symreal_a), REAL b[REAL_EITHER((n), )])
double corner(int n, const double a[n][n], double b[n])
// CHECK: { REAL_ONLY(::symreal::SymrealVariableRows<const REAL, 1> a(symreal_a, (n));)
{
    return a[n - 1][0] * b[0];
}

// CHECK: { REAL_ONLY(::symreal::SymrealVariableRows<REAL, 2> a(symreal_a, (n), (m));)
static double sum(int n, int m, double (*a)[n][m], double scale)
{
    double s = 0;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < n; i++)
            for (int j = 0; j < m; j++) s += a[k][i][j] * (i + 1) * scale;
    a[1][0][0] += s;
    return s + (a[1][0][0] > scale ? a[0][1][1] : (*a)[0][0]);
}

#ifdef SIZE
// SIZE: arrays.c:[[@LINE+1]]:62: error: the size of an array of variable extents, or of a part of one, is asked for [SYM037]
static double size(int n, double a[n][n]) { return a[0][0] * sizeof a[0]; }
#endif

static double f(double x)
{
    int n = 2;
    // CHECK: v[n], REAL_EITHER((cube[2][n][n + 1]), symreal_cube[(2) * (n) * (n + 1)]); REAL_ONLY(::symreal::SymrealVariableRows<REAL, 2> cube(symreal_cube, (n), (n + 1));)
    double a[2][2] = {{x, 1}, {2, x}}, v[n], cube[2][n][n + 1];
    // CHECK: struct named u = {REAL_EITHER(("xy"), {120, 121}), x};
    struct named u = {"xy", x};
    v[0] = x;
    v[1] = 2 * x;
    for (int i = 0; i < 2 * n * (n + 1); i++) (&cube[0][0][0])[i] = i * x;
    return first(n, v, v, v) + corner(n, a, v) + sum(n, n + 1, cube, x) + cube[1][0][0] + u.value * u.name[1] +
           magic[2] + name[3] + rows[1][1] + bytes[0];
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
