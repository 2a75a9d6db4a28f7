#include <stdio.h>
#include <stdlib.h>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  char text[40];
  sprintf(text, "%.3f", x);
  return atof(text) + x;
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
