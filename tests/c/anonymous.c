/* A structure without a name within another: with REALs in it, it has one in symbolic mode. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %rewrite %s > %t.rewritten.c && %rewrite %t.rewritten.c | diff %t.rewritten.c -
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stddef.h>
#include <stdio.h>

typedef union {
    struct {
        double x, y;
        // CHECK: } REAL_ONLY(symreal_with_x);
    };
    double c[2];
    struct {
        int low, high;
        // CHECK: {{^}}    };
    };
} vec;

struct body {
    int id;
    union {
        vec place;
        struct {
            double u;
            struct {
                double v;
                // CHECK: } REAL_ONLY(symreal_with_v);
            };
        };
    };
};

// CHECK: #define X(p) (REAL_PART(used, 0, 0, {{.*}}, REAL_READ({{.*}}, (p)->REAL_ONLY(symreal_with_x.) x)))
#define X(p) ((p)->x)

static double f(vec *p, struct body *b)
{
    // CHECK: p->REAL_ONLY(symreal_with_x.) y) += X(p) * 
    p->y += X(p) * p->c[1];
    // CHECK: b->REAL_ONLY(symreal_with_u.symreal_with_v.) v) = 2 * {{.*}}b->REAL_ONLY(symreal_with_u.) u);
    b->v = 2 * b->u;
    // CHECK: offsetof(struct body, REAL_ONLY(symreal_with_u.symreal_with_v.) v)
    return p->c[1] + b->place.c[1] + (double)offsetof(struct body, v);
}

int main(void)
{
    double q = 1.5, y;
    vec p;
    struct body b = {1, {{{1, 2}}}};
#pragma symreal input(q)
    p.x = q;
    p.y = q * q;
    b.place.x = q;
    y = f(&p, &b);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
