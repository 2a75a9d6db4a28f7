/* The same in C: a truth value, an enumeration, an expression of another type.
RUN: rm -rf %t && mkdir %t && cd %t
RUN: %symreal generate %s -o %t/ --decisions=auto
RUN: %symreal verify --samples=100 --min-samples=10 %s is_above.c colour_of.c rounded.c > %t/verified 2>&1
RUN: FileCheck %s --check-prefix=SAME < %t/verified
SAME: kernel is_above, mode finite
SAME: value_return 1 0 0{{$}}
SAME: kernel colour_of, mode finite
SAME: value_return 1 0 0{{$}}
SAME: kernel rounded, mode finite
SAME: value_return 1 0 0{{$}}
*/
#include <stdbool.h>
#include <stdio.h>
#pragma symreal function input(x) range(-2, 2) output(return)
bool is_above(double x) { return x > 0.5; }

enum colour { red, green = 5 };
#pragma symreal function input(x) range(-2, 2) output(return)
enum colour colour_of(double x) {
  if (x > 1) return green;
  return red;
}

#pragma symreal function input(x) range(-20, 20) output(return)
int rounded(double x) {
  int i = x * 2.5;
  return i;
}

int main(void) {
  printf("%d %d %d\n", is_above(0.25), colour_of(0.25), rounded(1.5));
  return 0;
}
