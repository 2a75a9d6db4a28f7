/* A tag is no name of its own in C++: it hides others, and what a structure declares stays in it, if anything. */
// RUN: not %rewrite %s 2>&1 | FileCheck %s --implicit-check-not=error:
char T[5];
double scale(double x) { return x; }
typedef float number;
enum { ON = 5 };
struct point { double x; };

double hidden(double x)
{
    struct T { double v[10]; };
    struct scale { double v; };
    // CHECK: names.c:[[#@LINE+1]]:23: error: 'T' is a tag here in C++, which hides the other name [SYM037]
    double y = sizeof(T) + sizeof(struct T);
    {
        struct number { double v; } one = {x};
        // CHECK: names.c:[[#@LINE+1]]:15: error: 'number' is a tag here in C++
        y += (number)one.v;
    }
    // CHECK: names.c:[[#@LINE+1]]:10: error: 'scale' is a tag here in C++
    y += scale(x);
    return y + sizeof(number);
}

double left(double x)
{
    struct part { enum { ON = 1, OFF } state; struct point { double v[3]; } at; };
    // CHECK: names.c:[[#@LINE+1]]:30: error: 'point' is declared in a structure, and is another in C++
    double y = sizeof(struct point);
    // CHECK: names.c:[[#@LINE+1]]:12: error: 'ON' is declared in a structure, and is another in C++
    y += x*ON;
    return y;
}

// CHECK: names.c:[[#@LINE+1]]:8: error: a structure without members has another size in C++
struct nothing { };

/* In the same block, and with the word before it, there is no doubt. */
double point(double x)
{
    struct T { double v; } T = {x};
    struct point *point = (struct point *)&T;
    return T.v + point->x + sizeof(T) + sizeof(struct point) + ON;
}
