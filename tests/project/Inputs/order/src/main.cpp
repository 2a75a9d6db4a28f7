#include "inner/deep.h"
#include <cstdio>
int main() {
  double x = 2;
#pragma symreal input(x)
  double const y = shifted(scaled(x));
#pragma symreal output(y) generate("order.c")
  std::printf("%g %s\n", y, where);
}
