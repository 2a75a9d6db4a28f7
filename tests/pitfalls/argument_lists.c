/* Numbers that go through `...` stay symbolic wherever a rewritten function reads them from the list: a helper takes it
   by value or by pointer, from a structure, through a pointer to a function. What prints the same list prints the
   values of the run. */
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
// RUN: FileCheck %s --input-file=%t.c
// RUN: grep -v "pragma symreal" %s > %t.plain.c
// RUN: %cc %t.plain.c -o %t.original -lm && %symreal-cc %t.plain.c -o %t.symbolic -lm
// RUN: %t.original > %t.expected && %t.symbolic | diff %t.expected -
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s --check-prefix=PRINTED
#include <stdarg.h>
#include <stdio.h>

struct cursor { va_list list; int left; };

static double weighted(int n, va_list list)
{
    double sum = 0;
    for (int i = 1; i <= n; i++) sum += i * va_arg(list, double);
    return sum;
}
static double handed_on(int n, va_list list) { return weighted(n, list); }
static double by_value(int n, ...)
{
    va_list list;
    va_start(list, n);
    double const sum = handed_on(n, list);
    va_end(list);
    return sum;
}

static double next(va_list *list) { return va_arg(*list, double); }
static double by_pointer(int n, ...)
{
    va_list list, copy;
    va_start(list, n);
    va_copy(copy, list);
    double product = 1;
    for (int i = 0; i < n; i++) product *= next(&copy);
    va_end(copy);
    product += next(&list);
    va_end(list);
    return product;
}

static double drained(struct cursor *cursor)
{
    double sum = 0;
    while (cursor->left-- > 0) sum -= va_arg(cursor->list, double);
    return sum;
}
static double in_structure(int n, ...)
{
    struct cursor cursor;
    cursor.left = n;
    va_start(cursor.list, n);
    double const sum = drained(&cursor);
    va_end(cursor.list);
    return sum;
}

static double (*const readers[])(int, va_list) = {weighted, handed_on};
static double by_table(int which, int n, ...)
{
    va_list list;
    va_start(list, n);
    double const sum = readers[which](n, list);
    va_end(list);
    return sum;
}

/* It reads a number, and prints all of them. */
static double logged(char const *format, ...)
{
    va_list list;
    va_start(list, format);
    vprintf(format, list);
    va_end(list);
    va_start(list, format);
    int const skipped = va_arg(list, int);
    double const first = va_arg(list, double);
    va_end(list);
    return first + skipped;
}

// CHECK: input[0]
// CHECK: input[1]
#pragma symreal function input(x[0:2]) output(y[0:5])
void kernel(double const *x, double *y)
{
    y[0] = by_value(3, x[0], 2.0, x[1]);
    y[1] = by_pointer(2, x[0], x[1]);
    y[2] = in_structure(2, x[1], x[0]);
    y[3] = by_table(1, 2, x[0], x[1]);
    // PRINTED: 3|0.500|  1.5e+00|word|z|0.2|100%
    y[4] = logged("%d|%.3f|%9.1e|%s|%c|%.*g|100%%\n", 3, x[0], x[1] * 2, "word", 'z', 2, x[0] / 2.5);
}

int main(void)
{
    double x[2] = {0.5, 0.75}, y[5];
    kernel(x, y);
    for (int i = 0; i < 5; i++) printf("%.17g\n", y[i]);
    return 0;
}
