#include <stdio.h>
static unsigned exponent(unsigned char const *bytes) { return bytes[7]; }
#pragma symreal function input(x) output(return)
double kernel(double x)
{
    double h = x;
    unsigned char const *bytes = (unsigned char const *)&h;
    return x + exponent(bytes);
}
int main(void) { printf("%.17g\n", kernel(0.7)); return 0; }
