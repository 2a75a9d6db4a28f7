#include <stdio.h>
#pragma symreal function input(x) output(return)
double kernel(double x)
{
    __typeof__(x > 1) count = x > 1;
    count += 5;
    return count * x;
}
int main(void) { printf("%g\n", kernel(1.25)); return 0; }
