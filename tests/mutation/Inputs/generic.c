#include <stdio.h>
#define KIND(x) _Generic((x), int: 3, char *: 5, default: 9)
#pragma symreal function input(x) output(return)
double kernel(double x) { return x * KIND(x > 1) + KIND("text"); }
int main(void) { printf("%g\n", kernel(1.25)); return 0; }
