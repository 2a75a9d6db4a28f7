#include <stdarg.h>
#include <stdio.h>
#include <wchar.h>
static int length(wchar_t const *format, ...)
{
    wchar_t text[100];
    va_list list;
    va_start(list, format);
    int const result = vswprintf(text, 100, format, list);
    va_end(list);
    return result;
}
#pragma symreal function input(x) output(return)
double kernel(double x) { return x + length(L"%g", x); }
int main(void) { printf("%g\n", kernel(0.7)); return 0; }
