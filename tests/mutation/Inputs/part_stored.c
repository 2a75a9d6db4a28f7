#include <stdint.h>
#include <stdio.h>
union shape {
    double value;
    struct { uint32_t low, high; } part;
};
#pragma symreal function input(x) output(return)
double kernel(double x)
{
    union shape u;
    u.value = x;
    u.part.low = 0;
    return u.value;
}
int main(void) { printf("%.17g\n", kernel(0.7)); return 0; }
