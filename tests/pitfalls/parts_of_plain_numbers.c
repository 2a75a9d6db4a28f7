/* Parts of numbers are stored, and all is right: the number is an ordinary one, all of its bytes are stored, or the memory
   holds something else from then on. */
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=50
#include <math.h>
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
    unsigned char bytes[8];
} shape;

struct variant {
    int is_number;
    union {
        double number;
        int whole;
    };
};

struct record {
    double value, weights[3];
    int count;
};

/* Both halves, over what the memory held before. */
static double power_of_two(double x, int k)
{
    shape u;
    u.value = x;
    u.part.high = (uint32_t)(1023 + k) << 20;
    u.part.low = 0;
    return x * u.value;
}

static double by_fields(double x, unsigned exponent)
{
    shape u = {.value = x};
    u.field.sign = 0;
    u.field.exponent = 1023 + exponent;
    u.field.fraction_high = 1u << 19;
    u.field.fraction_low = 0;
    return u.value + x;
}

static double by_bytes(double x, double plain)
{
    shape u = {.value = x};
    unsigned char source[8];
    memcpy(source, &plain, 8);
    for (int i = 0; i < 8; i++) u.bytes[i] = source[i];
    double h = x;
    unsigned char *at = (unsigned char *)&h;
    for (int i = 0; i < 8; i++) at[i] = source[7 - i];
    for (int i = 0; i < 4; i++) {
        unsigned char other = at[i];
        at[i] = at[7 - i];
        at[7 - i] = other;
    }
    return u.value + h + x;
}

/* An interpreter's values: an integer takes the place of a number, and the other way round. */
static double interpreted(double x)
{
    struct variant stack[2];
    stack[0].is_number = 1;
    stack[0].number = 2 * x;
    double y = stack[0].number;
    stack[0].is_number = 0;
    stack[0].whole = 4;
    stack[1] = stack[0];
    y += stack[0].whole + stack[1].whole * x;
    stack[0].number = x * x;
    stack[0].is_number = 1;
    return y + stack[0].number;
}

static double of_plain(double x, double plain)
{
    shape u = {.value = plain};
    u.part.low = 0;
    double h = plain;
    memset(&h, 0, 4);
    ((uint32_t *)&plain)[0] = 0;
    return u.value * x + h + plain;
}

static double whole(double x, int n)
{
    struct record s = {x, {x, x, x}, 3}, t;
    double copy[3];
    memset(&t, 0, sizeof t);
    memset(&s.weights[1], 0, sizeof(double) * n);
    memcpy(&t, &s, sizeof s);
    memcpy(copy, t.weights, sizeof copy);
    memset(&t.count, 0, sizeof t.count);
    return t.value + copy[0] + copy[1] + t.count;
}

/* The low word of a number that was just made of integers, where a symbolic one lay before. */
static double joined(uint32_t high, uint32_t low)
{
    double z;
    *(1 + (int32_t *)&z) = (int32_t)high;
    *(int32_t *)&z = (int32_t)low;
    return z;
}

static double leave_behind(double x)
{
    double volatile left[64];
    for (int i = 0; i < 64; i++) left[i] = x * i;
    return left[63];
}

#pragma symreal function input(x) range(0.5, 2) output(return)
double sum(double x)
{
    double y = power_of_two(x, 3) + by_fields(x, 2) + by_bytes(x, 1.25) + interpreted(x);
    y += leave_behind(x);
    y += joined(0x40080000, 1) * x;
    return y + of_plain(x, 1.1) + whole(x, 2);
}

int main(void)
{
    printf("%.17g\n", sum(0.75));
    return 0;
}
