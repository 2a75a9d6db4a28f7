/* In gcc's C an integer that was computed from real numbers has, beside a bit-field that is wider than int, as many bits as that. */
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o code.c --decisions=select && FileCheck %s < code.c
// CHECK: wide_ushr(wide_shl(
// RUN: %symreal verify %s code.c --samples=100 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: kernel widths, mode finite: 100 samples and 6 around decisions, 106 within the premises
// SAME: value_return {{ *}}1 {{ *}}0 {{ *}}0
#include <math.h>

struct part { unsigned long long b : 46; long long s : 40; };

#pragma symreal function input(x) range(-10, 10) output(return)
double widths(double x)
{
    struct part f = {-7 - 3u, -5};
    unsigned int const k = (int)ceil(fmod(x * 7, 100.0));
    int const i = (int)(1000 * x);
    return (double)(f.b * k) + (double)(f.s * i) - (double)(f.b - i) / 3 + (double)(i < f.b);
}

int main(void) { return widths(-4.4) == 0; }
