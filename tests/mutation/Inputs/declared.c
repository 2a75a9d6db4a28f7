#include <stdio.h>
double gain;
#pragma symreal function input(x) constant(gain) output(return)
double kernel(double x) { return gain * x; }
double gain = 2;
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
