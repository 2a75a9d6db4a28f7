#include <stdio.h>
#pragma symreal function input(x, u) output(return)
double kernel(double x, double u)
{
    static int m[2];
    if (x > 0)
        m[0] = 3;
    else
        m[1] = 1;
    return m[0] * u;
}
int main(void) { printf("%g\n", kernel(1.5, 2)); return 0; }
