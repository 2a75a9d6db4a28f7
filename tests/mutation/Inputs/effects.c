#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#pragma symreal function input(x) output(return)
double kernel(double x)
{
    setenv("SEEN", "1", 1);
    return 2 * x;
}
int main(void) { printf("%g\n", kernel(0.5)); return 0; }
