/* A tag has a name of its own in C, which another type may have as well; a truth value counts. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s 
// RUN: %rewrite %s > %t.rewritten.c && %rewrite %t.rewritten.c | diff %t.rewritten.c -
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c  2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>

typedef double vec[3];
// CHECK: struct REAL_EITHER((vec), symreal_tag_vec) {{.*}} REAL x, y; };
struct vec { double x, y; };
// CHECK: typedef struct REAL_EITHER((body), symreal_tag_body) {{.*}} REAL m; } *body;
typedef struct body { double m; } *body;
typedef struct same { double v; } same;

// CHECK: static REAL f(struct REAL_EITHER((vec), symreal_tag_vec) *a, vec b, body c, struct same *s)
static double f(struct vec *a, vec b, body c, struct same *s)
{
    _Bool t = 0, u = 2;
    // CHECK: REAL_ENUM(t)++;
    t++;
    // CHECK: int old = REAL_ENUM(t)++, two = ++REAL_ENUM(t), three = REAL_ENUM(u)--;
    int old = t++, two = ++t, three = u--;
    return a->x * b[1] + c->m + s->v + t + 4 * old + 8 * two + 16 * three + --u;
}

int main(void)
{
    double x = 1.5, y;
    struct vec a = {2, 3};
    vec b = {1, 2, 3};
    struct body c = {4};
    same s = {5};
#pragma symreal input(x)
    a.x = b[1] = c.m = s.v = x;
    y = f(&a, b, &c, &s);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
