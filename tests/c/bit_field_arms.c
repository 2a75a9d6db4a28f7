/* A bit-field that is narrower than int is an int in C also as an arm of ?:, where g++ takes the type it is declared with. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %cc %s -o %t.orig && %symreal-cc %s -o %t.exe && %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>

struct fields { unsigned a : 6; unsigned b : 5; unsigned long c : 10; unsigned char d : 3; unsigned all : 32; int s : 4; };

#define EITHER(n, o, i) ((n) ? (o).a : (i))

double chosen(double x, struct fields o, int n, int i, unsigned u)
{
    // CHECK: REAL y = x * (n ? (int)(o.a) : i);
    double y = x * (n ? o.a : i);
    y += x * (n ? o.b : o.c) + (-51 + (n ? o.a : o.b) < 0) * 1e2 + (-51 + (n ? o.c : i) < 0) * 1e3;
    // CHECK: (n ? o.all : i)
    y += (n ? i : (o.b)) / x + (-51 + (n ? o.all : i) < 0) * 1e4 + (-51 + (n ? o.a : u) < 0) * 1e5;
    y += (-51 + (o.a ?: i) < 0) * 1e6 + (-51 + (n ? (n ? o.a : o.b) : i) < 0) * 1e7 + (n ? o.s : o.d) * x;
    return y + (-51 + EITHER(n, o, i) < 0) * 1e8 + EITHER(!n, o, i);
}

int main(void)
{
    double x = 3, y;
    struct fields o = {8, 3, 4, 1, 9, -5};
#pragma symreal input(x)
    y = chosen(x, o, 1, -2, 7);
    y += chosen(x, o, 0, -3, 8);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
