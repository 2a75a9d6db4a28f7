// (a < b) <= (c == d): which of two truth values is the larger.
// RUN: cp %s %t.cpp
// RUN: %symreal generate %s -o %t.c --decisions=explore && %symreal verify %s %t.c --samples=200
// RUN: %symreal generate %t.cpp -o %t2.c --decisions=guard && %symreal verify %t.cpp %t2.c --samples=200 --min-samples=20
// RUN: %same %s
#include <stdio.h>

#pragma symreal function input(x[0:2]) range(-1, 1) output(return)
double k(double const *x) {
  double y = x[0];
  if ((x[0] < 0) < (x[1] < 0)) y += 1;
  if ((x[0] < 0) > (x[1] > 0.5)) y += 2;
  if ((x[0] == 0) <= (x[1] < 0)) y += 4;
  if ((x[0] > 0.5) >= (x[1] < 0.5)) y += 8;
  return y;
}
int main(void) {
  double const x[2] = {0.25, -0.5};
  printf("%g\n", k(x));
}
