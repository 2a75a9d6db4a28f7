/* A number that is read back from text in a locale's notation is that of one run, as with strtod. */
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#define _GNU_SOURCE
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>

#pragma symreal function input(x) output(return)
double rounded(double x)
{
    char text[40];
    locale_t c = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
    double y;
    sprintf(text, "%.3f", x);
    // CHECK: text_in_locale.c:[[@LINE+1]]:18: error: 'text' is read, which holds the text of x [SYM143]
    y = strtod_l(text, NULL, c);
    freelocale(c);
    return y + x;
}

int main(void)
{
    printf("%g\n", rounded(5.3));
    return 0;
}
