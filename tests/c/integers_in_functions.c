/* An integer that was computed from real numbers is an argument of a mathematical function, whose result becomes an integer again. */
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify %s %t.c --samples=100 --min-samples=10
#include <math.h>

#pragma symreal function input(x, c) range(-4, 4) output(return)
double rounded(double x, double c)
{
    int k = x;
    int of_variable = 10 * cos(k);
    int of_sum = 10 * sin(k + 1);
    int of_function = sqrt(k * k);
    int chosen = fabs(x > c ? 10 : k);
    int converted = exp((int)c);
    return of_variable * x + of_sum + of_function - chosen + converted;
}

int main(void) { return rounded(1.5, 0.25) > 1e9; }
