/* gcc's C computes with a bit-field that is wider than int in as many bits as it has. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %cc %s -o %t.orig && %symreal-cc %s -o %t.exe && %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>

struct fields { unsigned long long b : 40; long long s : 40; unsigned long c : 33; unsigned long small : 20; };

double scaled(double x, struct fields f, int n)
{
    // CHECK: REAL y = (REAL_WIDTH(40, false, f.b << 1)) * x;
    double y = (f.b << 1) * x;
    // CHECK: y += (REAL_WIDTH(40, false, REAL_WIDTH(40, false, f.b * 2) + REAL_WIDTH(40, false, f.c))) + f.b / x;
    y += (f.b * 2 + f.c) + f.b / x;
    y += (-1 < f.b) * 1e3 + (-1L < f.b) * 1e4 + (n - f.c) + -f.b;
    y += (f.s + f.b) + (f.s - 1) + (f.small - 2000000 < 0) * 1e5;
    f.b += f.b;
    f.b /= n;
    f.c -= 7;
    return y + f.b + f.c + (n ? f.b : n);
}

int main(void)
{
    double x = 3, y;
    struct fields f = {1ULL << 39, -5, 3, 77};
#pragma symreal input(x)
    y = scaled(x, f, -2);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
