/* Flags and modes of floating-point arithmetic, read or set in a kernel: what generated code does not have. */
// RUN: %same %s
// RUN: not %symreal generate %s -o %t.c --kernel=flags --run-args=flags 2>&1 | FileCheck %s --check-prefix=FLAGS
// RUN: not %symreal generate %s -o %t.c --kernel=up --run-args=up 2>&1 | FileCheck %s --check-prefix=UP
// RUN: not ls %t.c
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define DIVIDED fetestexcept(FE_DIVBYZERO)

#pragma symreal function input(x) output(return)
double flags(double x)
{
    double y;
    // FLAGS: floating_environment.c:[[@LINE+1]]:5: error: the kernel uses feclearexcept, which clears the floating-point flags [SYM144]
    feclearexcept(FE_ALL_EXCEPT);
    y = 1 / x;
    // FLAGS: floating_environment.c:[[@LINE+1]]:9: error: the kernel uses fetestexcept, which reads the floating-point flags [SYM144]
    if (DIVIDED) y = 0;
    return y;
}

#pragma symreal function input(x) output(return)
double up(double x)
{
    // UP: floating_environment.c:[[@LINE+1]]:24: error: the kernel uses fegetround, which reads the rounding mode [SYM144]
    int const before = fegetround();
    double y;
    // UP: floating_environment.c:[[@LINE+1]]:5: error: the kernel uses fesetround, which sets the rounding mode [SYM144]
    fesetround(FE_UPWARD);
    y = rint(x) + x / 3;
    fesetround(before);
    return y;
}

int main(int count, char **names)
{
    feclearexcept(FE_ALL_EXCEPT); /* outside of the kernels it is the program's own business */
    if (count > 1 && strcmp(names[1], "flags") == 0) printf("%g\n", flags(5.3));
    if (count > 1 && strcmp(names[1], "up") == 0) printf("%g\n", up(5.3));
    printf("%d\n", fetestexcept(FE_INEXACT) != 0);
    return 0;
}
