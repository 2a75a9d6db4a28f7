/* A variable that C lets a file define several times is declared first, for C++. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %cc %s -o %t.orig && %symreal-cc %s -o %t.exe && %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: rm -rf %t && mkdir %t && cp %s %t/a.c && cd %t && %symreal rewrite a.c --out-root once && cd once && %symreal rewrite a.c --diff 2> log | count 0
#include <stdio.h>

typedef struct { double (*function)(double); int n; } method;

static double half(double x) { return x / 2; }
// CHECK: REAL_EITHER((static), extern "C++" { namespace { extern) const method first; REAL_EITHER((), }})
static const method first;
// CHECK: REAL_EITHER((), extern) REAL twice;
double twice;
// CHECK-NEXT: {{^}}REAL once;
double once;
static method const *methods(void) { return &first; }
// CHECK: REAL_EITHER((static), extern "C++" { namespace {) const method first = {half, 3}; REAL_EITHER((), }})
static const method first = {half, 3};
// CHECK-NEXT: {{^}}REAL twice = 2;
double twice = 2;
// CHECK-NEXT: REAL_EITHER((), extern) const REAL seen[2] = {1, 2}, also = 3;
const double seen[2] = {1, 2}, also = 3;

int main(void)
{
    printf("%g %d\n", methods()->function(twice + once + seen[1] + also), first.n);
    return 0;
}
