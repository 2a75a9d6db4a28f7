#include <stdarg.h>
#include <stdio.h>
static double all(int n, va_list list)
{
    double sum = 0;
    for (int i = 1; i <= n; i++) sum += i * va_arg(list, double);
    return sum;
}
static double total(int n, ...)
{
    va_list list;
    va_start(list, n);
    double const sum = all(n, list);
    va_end(list);
    return sum;
}
#pragma symreal function input(x) output(return)
double kernel(double x) { return total(2, x, 1.0); }
int main(void) { printf("%g\n", kernel(0.7)); return 0; }
