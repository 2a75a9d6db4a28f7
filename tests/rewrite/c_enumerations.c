/* In C an enumeration is an integer: what converts to it and from it by itself is written out. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>

enum side { left, right };
enum { count = 4 };
enum colour { red, green };
enum side side_of(int n)
{
    int i;
    // CHECK: if (n < 0) return REAL_FIT(-1);
    if (n < 0) return -1;
    // CHECK: if (n > 9) return REAL_FIT(green);
    if (n > 9) return green;
    for (i = 0; i < 2; ++i)
        // CHECK: if (i == n) return REAL_FIT(i);
        if (i == n) return i;
    return right;
}
double twice(double x) { return 2 * x; }
double chosen(int n, enum side a, enum side b)
{
    // CHECK: return twice(REAL_TO(unsigned int, n ? REAL_COUNTED(a) : REAL_COUNTED(b))) + twice(REAL_TO(int, right)) + (n ? REAL_TO(unsigned int, (1, b)) : 2.0) / REAL_TO(int, count);
    return twice(n ? a : b) + twice(right) + (n ? (1, b) : 2.0) / count;
}
int sides(void)
{
    enum side s;
    int n = 0;
    for (s = left; s <= right; s++) n += s + 1;
    for (s = right; s > left; --s) ++n;
    // CHECK: REAL_ENUM(s) += 2, REAL_ENUM(s) <<= 1, REAL_ENUM(s) |= right;
    s += 2, s <<= 1, s |= right;
    return n + s--;
}

int main(void)
{
    double x = 3, y;
#pragma symreal input(x)
    y = x * chosen(sides() == 9, side_of(1), left);
#pragma symreal output(y) generate("y.c")
    printf("%g\n", y);
    return 0;
}
