/* A list with a symbolic number in it goes to a function that is not rewritten, from where something comes back; or a
   function that reads the number hands the list to one that would print the bytes of its node. */
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <stdarg.h>
#include <stdio.h>
#include <wchar.h>
#include <syslog.h>

static double both(char const *format, ...)
{
    va_list list;
    va_start(list, format);
    // CHECK-DAG: argument_list_leaves.c:[[@LINE+1]]:5: error: a list of arguments with a REAL in it goes to 'vsyslog', which is outside the roots [SYM031]
    vsyslog(LOG_DEBUG, format, list);
    va_end(list);
    va_start(list, format);
    double const first = va_arg(list, double);
    va_end(list);
    return first;
}
static int measured(wchar_t const *format, ...)
{
    wchar_t text[100];
    va_list list;
    va_start(list, format);
    // CHECK-DAG: argument_list_leaves.c:[[@LINE+1]]:24: error: a list of arguments with a REAL in it goes to 'vswprintf', which is outside the roots [SYM031]
    int const length = vswprintf(text, 100, format, list);
    va_end(list);
    return length;
}
/* Only prints: it is given the value. */
static void told(char const *format, ...)
{
    va_list list;
    va_start(list, format);
    vsyslog(LOG_DEBUG, format, list);
    va_end(list);
}

#pragma symreal function input(x) output(return)
double kernel(double x)
{
    told("%g", x);
    // CHECK-DAG: argument_list_leaves.c:[[@LINE+1]]:{{[0-9]+}}: note: 'both' is given a REAL here
    double y = both("%g", x);
    return y + measured(L"%g", x);
}

int main(void) { printf("%g\n", kernel(0.5)); return 0; }
