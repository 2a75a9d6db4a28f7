#include <stdio.h>
static FILE *file;
#pragma symreal function input(x) output(return)
double kernel(double x)
{
    fputc('x', file);
    return 2 * x;
}
int main(void)
{
    file = tmpfile();
    printf("%g\n", kernel(0.5));
    return 0;
}
