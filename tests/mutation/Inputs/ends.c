#include <stdio.h>
#pragma symreal function input(x) range(3, -3) output(return)
double kernel(double x) { return x * x; }
int main(void) { printf("%g\n", kernel(0.7)); return 0; }
