/* Parameters by value are the kernel's own, also those that its caller puts on the stack: they may be changed. */
// RUN: %same %s
// RUN: rm -rf %t && mkdir %t && %symreal generate %s -o %t/ 2>&1 | FileCheck %s --implicit-check-not="[SYM"
// CHECK: kernel summed
// CHECK: kernel walked
// RUN: %symreal verify %s %t/summed.c %t/walked.c --samples=100
// RUN: cp %s %t/p.cpp && %symreal generate %t/p.cpp -o %t/ && %symreal verify %t/p.cpp %t/summed.c %t/walked.c --samples=100
// RUN: FileCheck %s --check-prefix=CODE < %t/summed.c
// CODE: output[0] =
// RUN: sed 's/constant(p.n)//' %s > %t/q.c && not %symreal generate %t/q.c -o %t/q/ 2>&1 | FileCheck %s --check-prefix=LISTED
// LISTED: error: kernel 'summed' reads 'p' (4), which is neither input nor parameter [SYM017]
#include <stdio.h>

struct part { double a, b, c; int n; };

#pragma symreal function input(p.a, p.b, p.c) constant(p.n) output(return)
double summed(struct part p)
{
    double y = 0;
    p.a *= 2;
    for (; p.n > 0; p.n--) y += p.a + p.b * p.c;
    return y;
}

#pragma symreal function input(a[0:2], h) constant(i, j, k, l, m, n) output(y[0:2])
void walked(double *a, double *y, int i, int j, int k, int l, int m, int n, double h)
{
    double *end = a + n;
    y[0] = y[1] = 0;
    for (; a != end; a++, m--) y[0] += *a * m;
    while (n-- > 0) y[1] += (i + j + k + l) * h;
}

int main(void)
{
    struct part p = {1, 2, 3, 4};
    double a[2] = {1, 2}, y[2];
    walked(a, y, 1, 2, 3, 4, 5, 2, 0.5);
    printf("%g %g %g\n", summed(p), y[0], y[1]);
    return 0;
}
