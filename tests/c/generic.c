/* _Generic: a macro of C++ takes it apart. */
// RUN: %rewrite %s -- -std=c11 | FileCheck %s
// RUN: %same %s -- -std=c11
// RUN: %rewrite %s -- -std=c11 > %t.rewritten.c && %rewrite %t.rewritten.c -- -std=c11 | diff %t.rewritten.c -
// RUN: %symreal generate %s -o %t.c -- -std=c11 && %symreal verify --samples=100 --min-samples=10 %s %t.c -- -std=c11 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>

// CHECK: #define NAME(x) _Generic((x), REAL REAL_EITHER((:), ,) "double", REAL_EITHER((default), ::symreal::SymrealOtherwise)REAL_EITHER((:), ,) "other", int const *REAL_EITHER((:), ,) "pointer")
#define NAME(x) _Generic((x), double: "double", default: "other", int const *: "pointer")
// CHECK: #define FORMAT(x) _Generic((x), int REAL_EITHER((:), ,) "%d", REAL_EITHER((default), ::symreal::SymrealOtherwise)REAL_EITHER((:), ,) REAL_EITHER((NULL), nullptr))
#define FORMAT(x) _Generic((x), int: "%d", default: NULL)
#define SIZE(array) _Generic(&(array), char (*)[sizeof(array)]: sizeof(array))

static double twice(double x) { return 2 * x; }
static int twice_int(int n) { return 2 * n + 1; }
#define TWICE(x) _Generic((x), double: twice, int: twice_int)(x)

int main(void)
{
    char text[9];
    int const *p = 0;
    double x = 1.5, y;
#pragma symreal input(x)
    y = TWICE(x) + TWICE(3) + (double)SIZE(text);
    // CHECK: _Generic({{.*}}p{{.*}}, int REAL_EITHER((:), ,) "%d", REAL_EITHER((default), ::symreal::SymrealOtherwise)REAL_EITHER((:), ,) REAL_EITHER((NULL), nullptr));
    char const *format = _Generic(p, int: "%d", default: NULL);
    if (format) y = 0;
    format = FORMAT(p);
    if (format) y = 0;
    y += NAME(x)[0] + 2 * NAME(p)[0] + 3 * NAME('c')[0];
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
