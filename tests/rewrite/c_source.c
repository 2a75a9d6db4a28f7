/* C is compiled as C++ in symbolic mode: conversions that C makes by itself are written out. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
#include <stdlib.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

struct node { double value; struct node *next; };
static char given_name[8] = "name";
enum side { left, right };
static int order(const void *a, const void *b)
{
    // CHECK: const REAL *x = (const REAL *)(a), *y = (const REAL *)(b);
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}
double smallest(int n, double *given)
{
    // CHECK: REAL *x = (REAL *)(malloc(n * sizeof *x));
    double *x = malloc(n * sizeof *x);
    // CHECK: struct node *head = (struct node *)(calloc(1, sizeof(struct node)));
    struct node *head = calloc(1, sizeof(struct node));
    // CHECK: enum side s = REAL_FIT(1);
    enum side s = 1;
    double result;
    int i;
    for (i = 0; i < n; i++) x[i] = given[i];
    qsort(x, n, sizeof *x, order);
    // CHECK: result = REAL_READ({{.*}}, x[0]) + REAL_READ({{.*}}, head->value) + REAL_TO(unsigned int, s) + fabs(REAL_READ({{.*}}, x[0])) + (REAL_COND(isnan(REAL_READ({{.*}}, x[0]))) REAL_THEN 0.0 REAL_ELSE 1.0 REAL_END);
    result = x[0] + head->value + s + fabs(x[0]) + (isnan(x[0]) ? 0.0 : 1.0);
    // CHECK: i = REAL_TO(REAL_INT(int), floor(result));
    i = floor(result);
    printf("%d %g\n", i, result);
    // CHECK: char *found = (char *)(strchr(label, 'x')), *digit = (char *)(strchr("0123", '1')), *in = strchr(given_name, 'a');
    const char *label = "x", **labels = &label;
    char *found = strchr(label, 'x'), *digit = strchr("0123", '1'), *in = strchr(given_name, 'a');
    // CHECK: char *shown = n > 2 ? found : (char *)("none");
    char *shown = n > 2 ? found : "none";
    // CHECK: unsigned *bits = (unsigned int *)(&n);
    unsigned *bits = &n;
    // CHECK: char **words = (char **)(labels);
    char **words = labels;
    // CHECK: const void *any = words;
    const void *any = words;
    printf("%s %p %p %p %p %p\n", shown, (void *)found, (void *)digit, (void *)in, (void *)bits, any);
    free(x);
    free(head);
    return result;
}
