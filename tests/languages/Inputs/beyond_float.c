#include <stdio.h>
#pragma symreal function input(x) range(1, 1e15) output(return)
double cube(double x) { return x * x * x; }
int main(void) { printf("%g\n", cube(2.0)); }
