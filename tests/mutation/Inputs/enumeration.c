#include <stdio.h>
enum flags { NONE, FIRST, SECOND };
#pragma symreal function input(x) output(return)
double kernel(double x) {
  enum flags flags = FIRST;
  flags |= SECOND;
  return flags * x;
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
