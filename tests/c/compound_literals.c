/* (struct pair){1, x} is an object: it lives as long as the function's call, and its address can be taken. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s 
// RUN: %rewrite %s > %t.rewritten.c && %rewrite %t.rewritten.c | diff %t.rewritten.c -
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c  2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
// RUN: not %rewrite %s -- -DHALF 2>&1 | FileCheck %s --check-prefix=HALF
#include <stdio.h>

struct pair { double a, b; };
struct row { const double *values; int count; };

// CHECK: static const REAL *table = REAL_COMPOUND((REAL[]), {1, 2, 3});
static const double *table = (double[]){1, 2, 3};
static struct row rows[] = {{(double[]){4, 5}, 2}, {(const double[]){6}, 1}};

// CHECK: #define PAIR(a, b) (&REAL_COMPOUND((struct pair), {a, b}))
#define PAIR(a, b) (&(struct pair){a, b})
// CHECK: #define LIST(...) REAL_COMPOUND((REAL[]), {__VA_ARGS__})
#define LIST(...) (double[]){__VA_ARGS__}

static double product(const struct pair *p) { return p->a * p->b; }
static double sum(const double *p, int n)
{
    double s = 0;
    while (n-- > 0) s += p[n];
    return s;
}

static double f(double x)
// CHECK: { REAL_ONLY(::symreal::SymrealCompoundLiterals<{{[0-9]+}}> symreal_literals;)
{
    // CHECK: REAL *p = REAL_COMPOUND((REAL[]), {1, x, 3}), s = 0;
    double *p = (double[]){1, x, 3}, s = 0;
    struct pair *q, *other = 0;
    int k;
    p[0] += x;
    // CHECK: product(&REAL_COMPOUND((struct pair), {.a = 1, .b = x}))
    s += product(&(struct pair){.a = 1, .b = x}) + product(PAIR(x, 3)) + sum(LIST(x, 2), 2) + sum(LIST(x, 2, x), 3);
    q = &(struct pair){.b = x};
    q->a += 2;
    // CHECK: {{.*}}, (struct pair){x, 2}.b) + {{.*}}, (int){3});
    s += (struct pair){x, 2}.b + (int){3};
    for (k = 0; k < 3; k++) { // one object, with new values each time
        struct pair *here = &(struct pair){k, x};
        s += here->a * here->b;
        if (other && other != here) return 0;
        other = here;
        s += (k == 1 ? PAIR(x, k) : here)->a;
    }
    // CHECK: REAL_COMPOUND((char[ REAL_ONLY(3)]), {"ab"})[1]
    s += (char[]){"ab"}[1] + (int[]){5, 7}[1];
    return s + p[0] * p[1] + q->a * q->b + table[1];
}

#ifdef HALF
#define OPEN (struct pair){1,
// HALF: compound_literals.c:[[@LINE+1]]:{{.*}}: error: a compound literal is spelled in parts by macros
double half(double x) { return product(&OPEN x}); }
#endif

int main(void)
{
    double x = 1.5, y;
    printf("%g %g\n", rows[0].values[1], rows[1].values[0]);
#pragma symreal input(x)
#pragma symreal constant(table[0:3])
    y = f(x);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
