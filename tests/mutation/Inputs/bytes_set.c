#include <stdio.h>
#include <string.h>
#pragma symreal function input(x) output(return)
double kernel(double x)
{
    double h = x;
    memset(&h, 0, 4);
    return h;
}
int main(void) { printf("%.17g\n", kernel(0.7)); return 0; }
