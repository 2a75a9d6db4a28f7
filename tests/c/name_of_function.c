/* The name of a function as C has it, without its parameters. */
// RUN: env SYMREAL_ROOTS=%S %symreal-cc %s -o %t.exe && %t.exe | FileCheck %s
// RUN: %same %s
// CHECK: {{^}}half half 5{{$}}
#include <stdio.h>

static double half(double x)
{
    printf("%s %s %d\n", __PRETTY_FUNCTION__, __func__, (int)sizeof(__PRETTY_FUNCTION__));
    return x / 2;
}

int main(void) { return half(1) > 1; }
