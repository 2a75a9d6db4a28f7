// Beyond a guard the wrapper calls the original: a NaN that it gives there is no difference.
// RUN: %symreal generate %s -o %t.c --wrapper --decisions=guard && %symreal verify %s %t.c --samples=60 --min-samples=20 2>&1 | FileCheck %s
// CHECK: the wrapper was tried as well
// CHECK: return {{ *}}1 {{ *}}0 {{ *}}0
#include <math.h>

#pragma symreal function input(x) range(-1, 4) output(return)
double k(double x) {
  if (x < 0) return sqrt(x);
  return 2 * x;
}
int main(void) { return k(1.5) > 100; }
