#include <stdio.h>
struct fields { unsigned long long b : 40; };
#pragma symreal function input(x) output(return)
double kernel(double x) {
  struct fields f = {1ULL << 39};
  return (f.b << 1) * x + x;
}
int main(void) { printf("%g\n", kernel(5.3)); return 0; }
