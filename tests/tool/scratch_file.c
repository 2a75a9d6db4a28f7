/* scratch(file): what the kernel leaves in the static variables of its file does not matter, wherever these are declared.
   RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not=SYM0
   RUN: %symreal verify %s %t.c --samples=100
   RUN: cp %s %t.cpp && %symreal generate %t.cpp -o %t.2.c && %symreal verify %t.cpp %t.2.c --samples=100
   CHECK: kernel smooth
*/
#include <stdio.h>

static double work[4];
double last;

static double mean(double const *x)
{
    static double sum;
    static int calls;
    sum = x[0] + x[1];
    calls = 1;
    return sum / 2;
}

#pragma symreal function input(x[0:2]) scratch(file) output(return)
double smooth(double const *x)
{
    double *file = work;
    file[0] = mean(x);
    file[1] = file[0] * x[0];
    last = file[1];
    return last - x[1];
}

int main(void)
{
    double x[2] = {1, 2};
    printf("%g\n", smooth(x));
    return 0;
}
