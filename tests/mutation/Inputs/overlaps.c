#include <stdio.h>
#pragma symreal function input(x[0:2]) output(y[0:2])
void kernel(double const *x, double *y)
{
    y[0] = 2 * x[1];
    y[1] = x[0] + x[1];
}
int main(void)
{
    double x[2] = {0.5, 0.7}, y[2];
    kernel(x, y);
    printf("%g %g\n", y[0], y[1]);
    return 0;
}
