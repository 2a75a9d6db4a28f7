#include "shared.h"

/* Before C99 there is no such version, and math.h of C99 alone has no M_PI and defines isnan as a macro. */
#if __STDC_VERSION__ >= 199901L
#define YEAR (__STDC_VERSION__ / 100)
#else
#define YEAR 1989
#endif
#ifndef M_PI
#define M_PI 3.0
#endif
#ifdef isnan
#define HAS_MACRO 1
#else
#define HAS_MACRO 0
#endif
#ifdef __STRICT_ANSI__
#define STRICT 0.5
#else
#define STRICT 0.25
#endif
#if IS_CPP && FACTOR_OF > 3
#error "for C++ alone"
#endif
#if !defined(__GNUG__) && !defined INT_MAX
#define OTHER 7
#else
#define OTHER 8
#endif

double scaled(double x)
{
    x = from_cpp(x) + FACTOR * x;
    return x * M_PI + YEAR + HAS_MACRO * x + STRICT + OTHER * 1000.0 + (isnan(x) ? 1 : 0);
}
