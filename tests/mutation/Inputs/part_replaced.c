#include <stdio.h>
#pragma symreal function input(x) output(return)
double kernel(double x)
{
    double h = x;
    ((unsigned char *)&h)[0] = 0;
    return h;
}
int main(void) { printf("%.17g\n", kernel(0.7)); return 0; }
