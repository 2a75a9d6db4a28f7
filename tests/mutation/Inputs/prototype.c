#include <stdio.h>
double half();
#pragma symreal function input(x) output(return)
double kernel(double x) { return half(x) * 3; }
double half(x) double x; { return x / 2; }
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
