#include <stdio.h>
struct flags { unsigned n : 4; };
#pragma symreal function input(x) output(return)
double kernel(double x) {
  struct flags f = {1};
  f.n += x;
  return f.n * x;
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
