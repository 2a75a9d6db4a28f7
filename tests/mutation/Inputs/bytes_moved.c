#include <stdint.h>
#include <stdio.h>
#include <string.h>
#pragma symreal function input(x) output(return)
double kernel(double x)
{
    double h = x;
    uint32_t const zero = 0;
    memcpy(&h, &zero, sizeof zero);
    return h;
}
int main(void) { printf("%.17g\n", kernel(0.7)); return 0; }
