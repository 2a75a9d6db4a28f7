#include <math.h>
#include <stdio.h>
static double apply(double (*f)(double), double x) { return f(x); }
#pragma symreal function input(x) constant(odd) output(return)
double kernel(double x, int odd) { return apply(odd ? sin : cos, x); }
int main(void) { printf("%g\n", kernel(5.3, 1)); return 0; }
