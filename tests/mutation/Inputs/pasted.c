#include <float.h>
#include <stdio.h>
#define number double
#define double_EPSILON DBL_EPSILON
#define PASTE_(type, what) type##_##what
#define PASTE(type, what) PASTE_(type, what)
#pragma symreal function input(x) output(return)
number kernel(number x) { return x + PASTE(number, EPSILON) * 1e16; }
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
