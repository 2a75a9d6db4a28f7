#include <cstdio>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  double y = x;
  __asm__("xorb $0x80, 7+%0" : "+m"(y)); // changes the sign
  return y;
}
int main() { std::printf("%g\n", kernel(5.3)); }
