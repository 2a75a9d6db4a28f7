#include <stdio.h>
#pragma symreal function input(x, u) output(return)
double kernel(double x, double u)
{
    static int m;
    m = 1;
    if (x > 0) m = 3;
    return m * u;
}
int main(void) { printf("%g\n", kernel(1.5, 2)); return 0; }
