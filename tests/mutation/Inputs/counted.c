#include <stdio.h>
enum mode { OFF, ON, AUTO };
#pragma symreal function input(x) output(return)
double kernel(double x) {
  enum mode mode = OFF;
  return (mode - 2) * x;
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
