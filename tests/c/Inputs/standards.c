#include <stdio.h>

static int order = 0;
static int next(void) { return ++order; }
static int tens(void) { return 10 * ++order; }

double lexed(double x)
{
    double table[12] = {0}, y;
    int i;
    y = x //* a division, then a comment */ 2
        ;
    y += sizeof("??=") * 10; /* four or two characters ??/
*/
    table[next()] = tens() * x; /* the left side first */
    for (i = 0; i < 12; ++i) y += i * i * table[i] * 100;
    y += 9223372036854775808 / -2 < 0;
    return y;
}

int main(void)
{
    double x = 3, y;
#pragma symreal input(x) constant(order) scratch(order)
    y = lexed(x);
#pragma symreal output(y) generate("y.c")
    printf("%.17g\n", y);
    return 0;
}
