/* Words that C++20 took, as names of C.
   RUN: %symreal generate %s -o %t.c && FileCheck %s < %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c
*/
// CHECK: input[0]*6.0
#include <stdio.h>

static double scale(double consteval, int constinit) { return consteval * constinit; }

int main(void)
{
    double x = 0.5, y;
    int concept = 1, requires = 2, thread_local = 3;
#pragma symreal input(x)
    y = scale(x, concept + requires + thread_local);
#pragma symreal output(y) generate("y.c")
    printf("%g\n", y);
    return 0;
}
