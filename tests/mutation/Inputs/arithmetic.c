#include <stdio.h>
#pragma symreal function input(x, y) output(return)
__attribute__((optimize("fast-math"))) double kernel(double x, double y) { return (x + y) - x; }
int main(void) { printf("%g\n", kernel(5.3, 0.1)); return 0; }
