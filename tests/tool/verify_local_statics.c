/* Static integers of a function, as Fortran's translators write them, are written before they are read, and nobody else
   can read what is left in them: generate takes them for scratch, and so does verify.
   RUN: cp %s %t.cpp
   RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
   RUN: %symreal verify --cc clang-19 %s %t.c --samples=100
   RUN: %symreal generate %t.cpp -o %t.k.c && %symreal verify %t.cpp %t.k.c --samples=100
   A file's own is none, whatever it is called.
   RUN: not %symreal verify %s %t.c --samples=100 -- -DFILE_SCOPE 2>&1 | FileCheck %s
   CHECK: error: kernel 'sum': the original leaves 'k' changed, on 100 samples [SYM121]
*/
#include <stdio.h>

int k;

static double power(double x, int n)
{
    static int i;
    static double last[2]; /* never used */
    double y = 1 + 0 * sizeof last;
    for (i = 0; i < n; ++i) y *= x;
    return y;
}

#pragma symreal function input(x) output(return)
double sum(double x)
{
    static int i__1, list[2];
    double y = 0;
    list[1] = 3;
    for (i__1 = 1; i__1 <= list[1]; ++i__1) y += power(x, i__1);
#if defined(FILE_SCOPE) && !defined(MBD_SYMBOLIC) && !defined(MBD_REPLAY)
    k = 7;
#endif
    {
        static int k;
        k = 2;
        return k * y;
    }
}

int main(void)
{
    printf("%g\n", sum(1.5));
    return 0;
}
