#include <stdio.h>
#pragma symreal function input(x) output(return)
double kernel(double x) { return x * 2.5; }
int main(void) { printf("%g\n", kernel(0.7)); return 0; }
