// A choice between integers, of which one is made of a number, that is returned as a number.
// RUN: rm -rf %t && mkdir %t && cp %s %t/k.cpp
// RUN: %symreal generate %s -o %t/k_c.c --decisions=guard && %symreal verify --samples=100 --min-samples=10 %s %t/k_c.c
// RUN: %symreal generate %t/k.cpp -o %t/k_cpp.c --decisions=guard && %symreal verify --samples=100 --min-samples=10 %t/k.cpp %t/k_cpp.c
#include <stdio.h>

#pragma symreal function input(y) output(return) range(0.0, 4.0)
double clipped(double y) {
  int const k = (int)y;
  return k > 2 ? 4 : k;
}

int main(void) {
  printf("%g\n", clipped(1.5));
  return 0;
}
