#include <stdio.h>
char T[5];
#pragma symreal function input(x) output(return)
double kernel(double x) {
  struct T { double v[10]; };
  return x * sizeof(T);
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
