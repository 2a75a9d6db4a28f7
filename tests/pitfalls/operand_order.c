/* In C the left side of an assignment comes first, in C++ the right one. */
// RUN: %same %s
// RUN: %cc %s -o %t.orig && %symreal-cc %s -o %t.exe && %t.orig > %t.plain && %t.exe | diff %t.plain -
#include <stdarg.h>
#include <stdio.h>

static double state, table[4];
static double next(void) { return state = state * 3 + 1; }
static int place(void)
{
    state = state * 2;
    return 1;
}
static double differ(int n, ...)
{
    double y;
    va_list list;
    va_start(list, n);
    y = va_arg(list, double) - va_arg(list, double);
    va_end(list);
    return y;
}

int main(void)
{
    state = 1;
    table[place()] = next();
    printf("%.17g\n", table[1]);
    state = 1;
    table[place()] += next();
    printf("%.17g %.17g\n", table[1], differ(2, 5.0, 3.0));
    state = 1;
    printf("%.17g\n", next() - table[place()]);
    state = 1;
    state -= 2 * next();
    printf("%.17g\n", state);
    return 0;
}
