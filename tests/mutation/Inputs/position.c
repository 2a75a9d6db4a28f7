#include <stdio.h>
static FILE *file;
#pragma symreal function input(x) output(return)
double kernel(double x) { return x + (double)ftell(file); }
int main(void)
{
    file = tmpfile();
    fputs("some text", file);
    printf("%g\n", kernel(0.5));
    return 0;
}
