/* errno, as the caller of the kernel has left it, is no input that generated code has. */
// RUN: %same %s
// RUN: not %symreal generate %s -o %t.c --kernel=entered --run-args=entered 2>&1 | FileCheck %s --check-prefix=ENTERED
// RUN: not %symreal generate %s -o %t.c --kernel=counted --run-args=counted 2>&1 | FileCheck %s --check-prefix=COUNTED
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.own.c --kernel=own --run-args=own && %symreal verify %s %t.own.c --kernel=own --run-args=own --samples=50
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#pragma symreal function input(x) output(return)
double entered(double x)
{
    // ENTERED: error_number_before.c:[[@LINE+1]]:12: error: errno is read as the caller of the kernel has left it [SYM145]
    return errno == ERANGE ? x : 2 * x;
}

#pragma symreal function input(x) output(return)
double counted(double x)
{
    // COUNTED: error_number_before.c:[[@LINE+1]]:5: error: errno is read as the caller of the kernel has left it [SYM145]
    errno += 1;
    return x * errno;
}

#pragma symreal function input(x) output(return)
double own(double x)
{
    FILE *file;
    errno = 0;
    file = fopen("/nonexistent/file", "r");
    if (errno == ENOENT) x *= 3;
    return file ? 0 : x;
}

int main(int count, char **names)
{
    errno = 5;
    if (count > 1 && strcmp(names[1], "entered") == 0) printf("%g\n", entered(5.3));
    if (count > 1 && strcmp(names[1], "counted") == 0) printf("%g\n", counted(5.3));
    if (count > 1 && strcmp(names[1], "own") == 0) printf("%g\n", own(5.3));
    return 0;
}
