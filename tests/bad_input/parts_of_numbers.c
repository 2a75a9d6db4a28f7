/* A part of a symbolic number gets a new value: reported where it is stored, whatever is stored, if the rest is used. */
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not %symreal generate %s -o %t.c -- '-DCALL=set(x + 2, 4)' 2>&1 | FileCheck %s --check-prefix=SET
// RUN: not %symreal generate %s -o %t.c -- '-DCALL=moved(x)' 2>&1 | FileCheck %s --check-prefix=MOVED
// RUN: not %symreal generate %s -o %t.c -- '-DCALL=untyped(x + 4)' 2>&1 | FileCheck %s --check-prefix=UNTYPED
// RUN: not %symreal generate %s -o %t.c -- '-DCALL=cast(x + 5)' 2>&1 | FileCheck %s --check-prefix=CAST
// RUN: not %symreal generate %s -o %t.c -- '-DCALL=by_variable(x + 6)' 2>&1 | FileCheck %s --check-prefix=VARIABLE
// RUN: not %symreal generate %s -o %t.c -- '-DCALL=changed_bits(x)' 2>&1 | FileCheck %s --check-prefix=CHANGED
// RUN: not ls %t.c
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

typedef union {
    double value;
    struct {
        uint32_t low, high;
    } part;
    struct {
        unsigned fraction_low : 32, fraction_high : 20, exponent : 11, sign : 1;
    } field;
    uint16_t quarters[4];
} shape;

struct pair {
    double first, second;
};

static double low_word(double x)
{
    shape u;
    u.value = x;
    // CHECK-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind 'u.part.low' is overwritten, and the number is used at {{.*}}:[[@LINE+2]]:{{[0-9]+}} [SYM035]
    u.part.low = 0;
    return u.value;
}
static double high_word(double x)
{
    shape u = {.value = x};
    // CHECK-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind 'u.part.high' is overwritten, and the number is used
    u.part.high = 0x3ff80000;
    return u.value;
}
static double through_pointer(shape *u, double x)
{
    u->value = x;
    // CHECK-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind 'u->field.exponent' is overwritten, and the number is used
    u->field.exponent = 1022;
    return 2 * u->value;
}
static double quarter(double x, int i)
{
    shape u = {.value = x};
    // CHECK-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind 'u.quarters[i]' is overwritten, and the number is used
    u.quarters[i] = 0;
    return u.value;
}
static uint32_t other_word(double x)
{
    shape u = {.value = x};
    u.part.low = 7;
    // CHECK-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind 'u' are those of a symbolic value [SYM035]
    return u.part.high;
}
static shape with_high_word(double x, uint32_t high)
{
    shape u;
    u.value = x;
    // CHECK-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind 'u.part.high' is overwritten, and the number is used
    u.part.high = high;
    return u;
}
static double by_pointer_into_union(double x)
{
    shape u;
    uint32_t *high = &u.part.high;
    u.value = x;
    // CHECK-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind '*high' is overwritten, and the number is used
    *high = 0x3ff80000;
    return u.value;
}
static double set(double x, size_t count)
{
    double h = x;
    // SET-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind '&h' is overwritten [SYM035]
    memset(&h, 0, count);
    return h;
}
static double moved(double x)
{
    double h = x;
    uint32_t const zero = 0;
    // MOVED-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind '&h' is overwritten [SYM035]
    memcpy(&h, &zero, sizeof zero);
    return h;
}
static double untyped(double x)
{
    double h = x;
    // UNTYPED-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind '(void *)&h' is overwritten [SYM035]
    memset((void *)&h, 0, 7);
    return h;
}
static double of_another(double x, double y)
{
    double h = 1.0;
    // CHECK-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind '&h' are those of a symbolic value [SYM035]
    memcpy(&h, &y, 4);
    return h + x;
}
static double cast(double x)
{
    double h = x;
    // CAST-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind '((unsigned char *)&h)[0]' is overwritten [SYM035]
    ((unsigned char *)&h)[0] = 0;
    // CAST-DAG: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind '*(1 + (int32_t *)&x)' is overwritten [SYM035]
    *(1 + (int32_t *)&x) = 0x40080000;
    return h + x;
}
static double by_variable(double x)
{
    double h = 1.0;
    uint32_t *const words = (uint32_t *)&h;
    h = x;
    // VARIABLE: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: a part of the symbolic value behind 'words[1]' is overwritten [SYM035]
    words[1] = 0;
    return h;
}
static double changed_bits(double x)
{
    double h = 1.0;
    unsigned char *bytes = (unsigned char *)&h;
    h = x;
    // CHANGED: parts_of_numbers.c:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind 'bytes[7]' are those of a symbolic value [SYM035]
    bytes[7] ^= 0x80;
    return h;
}

int main(void)
{
    double x = 0.5, y = 0;
    shape u;
#pragma symreal input(x)
#ifdef CALL
    y = CALL;
#else
    shape const made = with_high_word(x * 5, 0x40000000);
    y += made.value + by_pointer_into_union(x * 6) + of_another(x, x + 7);
    y += through_pointer(&u, x + 1) + other_word(x + 1) + low_word(x * 2) + high_word(x * 3) + quarter(x * 4, 3);
#endif
#pragma symreal output(y) generate("y.c")
    printf("%g\n", y);
    return 0;
}
