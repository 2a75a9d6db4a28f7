/* A function of the mathematical library has one address, wherever the program takes it: compared, searched in tables,
   kept as const void *, as an integer. */
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=50
// RUN: %cc %s -o %t.orig -lm && %symreal-cc %s -o %t.exe -lm && %t.orig > %t.plain && %t.exe | diff %t.plain -
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

typedef double (*unary)(double);
typedef double (*binary)(double, double);

struct operation {
    char const *name;
    const void *function;
    double cost;
};

static double twice(double x) { return 2 * x; }

static const struct operation operations[] = {
    {"twice", twice, 1}, {"sin", sin, 2}, {"cos", cos, 3}, {"pow", pow, 4}, {"fabs", &fabs, 5}};
static unary const order[] = {cos, fabs, twice, sin};

static double cost(const void *function)
{
    for (unsigned i = 0; i < sizeof operations / sizeof *operations; i++)
        if (operations[i].function == function) return operations[i].cost;
    return 1e6;
}

static int position(unary function)
{
    for (int i = 0; i < 4; i++)
        if (order[i] == function) return i;
    return -1000;
}

static double derivative(unary f, double x)
{
    if (f == sin) return cos(x);
    if (f == cos) return -sin(x);
    if (twice == f) return 2;
    return f == fabs ? (x < 0 ? -1 : 1) : 1e6;
}

static double by_name(char const *name, double x)
{
    for (unsigned i = 0; i < sizeof operations / sizeof *operations; i++)
        if (strcmp(operations[i].name, name) == 0) {
            unary explicit = (unary)operations[i].function;
            double (*implicit)(double) = operations[i].function;
            return explicit == implicit ? implicit(x) : 1e6;
        }
    return 1e6;
}

static uintptr_t address(unary f) { return (uintptr_t)f; }

#pragma symreal function input(x) range(0.2, 0.9) output(return)
double sum(double x)
{
    binary power = pow;
    double (*scale)(double, int) = ldexp;
    double (*split)(double, double *) = modf;
    double whole, y = split(x, &whole);
    y += derivative(sin, x) + 3 * derivative(cos, x) + 5 * derivative(twice, x);
    y += cost(sin) * x + cost(cos) + cost((void *)pow) * x * x + cost(fabs) + cost(twice);
    y += position(sin) + 10 * position(fabs) + 100 * position(twice) + by_name("sin", x) + by_name("twice", x);
    y *= (power == pow) + 2 * (scale == ldexp) + 4 * (split == modf) + 8 * (address(sin) == address(order[3]));
    return y + power(x, 1.5) + scale(x, 2) + (memcmp(&operations[1].function, &(unary){sin}, sizeof(unary)) == 0);
}

int main(void)
{
    printf("%.17g %g %g %d\n", sum(0.5), cost(cos), derivative(sin, 0), position(cos));
    return 0;
}
