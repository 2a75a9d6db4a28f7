/* In C the objects of an enumeration without negative values are unsigned, and its enumerators are ints. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %cc %s -o %t.orig && %symreal-cc %s -o %t.exe && %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>

enum mode { OFF, ON, AUTO };
enum wide { LOW = 1, HIGH = 0x80000000 };
enum sign { MINUS = -1, PLUS = 1 };
struct part { enum mode mode : 2, all : 32; };
// CHECK: #define BELOW(a, b) (REAL_COUNTED((a)) < REAL_COUNTED((b)))
#define BELOW(a, b) ((a) < (b))
#define MODE(p) (p)->mode

double scaled(double x, enum mode m, enum sign s, struct part *p)
{
    int i, n = -7;
    double y;
    // CHECK: y = (REAL_COUNTED(m)-2) * x;
    y = (m-2) * x;
    // CHECK: y += (-1 < REAL_COUNTED(m)) * 10.0 + (m == ON) + (n < REAL_OF_C(int, LOW)) * 100.0;
    y += (-1 < m) * 10.0 + (m == ON) + (n < LOW) * 100.0;
    // CHECK: for (i = -1; i < REAL_COUNTED(m); i++)
    for (i = -1; i < m; i++) y += 1000;
    // CHECK: y += (n ? REAL_COUNTED(m) : n) + (n ? OFF : ON) + ~REAL_COUNTED(m);
    y += (n ? m : n) + (n ? OFF : ON) + ~m;
    // CHECK: n /= REAL_COUNTED(m) + 1;
    n /= m + 1;
    y += n + (s - 2) * 3.0 + (MODE(p) - 2) + (p->all - 2);
    // CHECK: y += x * REAL_TO(unsigned int, m) + BELOW(-1, m) + BELOW(m, -1) + BELOW(2.5, 3) * 7;
    y += x * m + BELOW(-1, m) + BELOW(m, -1) + BELOW(2.5, 3) * 7;
    return y;
}

int main(void)
{
    double x = 3, y;
    struct part p = {OFF, OFF};
#pragma symreal input(x)
    y = scaled(x, OFF, MINUS, &p);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
