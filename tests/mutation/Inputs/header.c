#include <stdio.h>
#pragma symreal function input(x, y) output(return)
double kernel(double x, double y) { return x * 2.5 - y; }
int main(void) { printf("%g\n", kernel(0.7, 0.5)); return 0; }
