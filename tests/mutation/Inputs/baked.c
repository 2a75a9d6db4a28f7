#include <stdio.h>
#pragma symreal function input(x) constant(mode) output(return)
double kernel(double x, int mode)
{
    if (mode == 1) return x * x;
    return x + mode;
}
int main(void) { printf("%g\n", kernel(0.7, 1)); return 0; }
