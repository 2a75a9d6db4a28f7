#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
static double both(char const *format, ...)
{
    char text[40];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    va_start(list, format);
    double const first = va_arg(list, double);
    va_end(list);
    return first + atof(text);
}
#pragma symreal function input(x) output(return)
double kernel(double x) { return both("%.3f", x); }
int main(void) { printf("%g\n", kernel(0.7)); return 0; }
