/* An argument that is a constant of the table on one path is hidden from compilers, which would round otherwise than the
   library where they unroll the loop.
   RUN: rm -rf %t && mkdir %t
   RUN: %symreal generate %s --reroll --decisions=select -o %t/k.c
   RUN: FileCheck %s --input-file=%t/k.c
   CHECK: for (int k = 0; k <
   CHECK: sin(at_run(
   RUN: %symreal verify %s %t/k.c --samples=200 -- -O3 2>&1 | FileCheck %s --check-prefix=SAME
   SAME: value_return {{ *}}1 {{ *}}0 {{ *}}0
*/
#include <math.h>

#pragma symreal function input(x[0:12]) output(return)
double clipped(double const *x) {
  static double const limit[12] = {0.7, 1.1, 0.3, 0.9, 1.7, 0.2, 1.9, 0.6, 1.3, 0.8, 0.4, 1.2};
  double sum = 0;
  for (int k = 0; k < 12; ++k) sum = 0.5 * sum + sin(x[k] > 1 ? limit[k] : x[k]);
  return sum;
}

int main(void) {
  double x[12];
  for (int k = 0; k < 12; ++k) x[k] = 0.25 * k;
  return clipped(x) > 100;
}
