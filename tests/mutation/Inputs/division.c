#include <stdio.h>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  return x //* a division, then a comment */ 2
    ;
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
