/* What a structure declares is known behind it in C; in C++ it is the structure's. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %rewrite %s > %t.rewritten.c && %rewrite %t.rewritten.c | diff %t.rewritten.c -
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>
#include <stdlib.h>

typedef struct {
    enum { SLOW, FAST } type;
    double x;
} pair;
struct outer {
    struct inner { double v; enum unit { M, KM } unit; } in;
};
union any { enum { NONE, SOME } tag; };

static void set(pair *p, int type, double x)
{
    // CHECK: p->type) = REAL_FIT(type);
    p->type = type;
    p->x = x;
}

// CHECK: static REAL length(struct REAL_ONLY(outer::) inner in)
static double length(struct inner in)
{
    // CHECK: in.unit == REAL_ONLY(outer::inner::) KM
    return in.unit == KM ? in.v * 1000 : in.v;
}

static const char *word(const char *name)
{
    // CHECK: char *REAL_EITHER((getenv), symreal_getenv)();
    char *getenv();
    return getenv(name);
}

int main(void)
{
    double x = 1.5, y;
    pair p;
    union any tag;
    struct outer o = {{2, M}};
    // CHECK: tag.tag = REAL_ONLY(any::) SOME;
    tag.tag = SOME;
    int const none = word("a name that nobody has") == NULL;
#pragma symreal input(x)
    set(&p, 1, x);
    // CHECK: p.type == REAL_ONLY(pair::) FAST
    y = p.type == FAST ? p.x : 0;
    o.in.v = x;
    y += length(o.in) + (tag.tag == SOME) + none;
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
