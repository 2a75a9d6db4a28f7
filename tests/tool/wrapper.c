/* A function with the signature of the original takes the original's place.
   RUN: rm -rf %t && mkdir %t
   RUN: %symreal generate %s -o %t/scaled.c --wrapper --prefix=scaled
   RUN: FileCheck %s < %t/scaled_wrapper.c
   CHECK: void scaled_sum(const double *x, double factor, double *sums)
   CHECK: scaled_compute(
   RUN: %cc -std=c99 -DMAIN_ONLY %s %t/scaled.c %t/scaled_wrapper.c -lm -o %t/swapped
   RUN: %cc -std=c99 -Wno-unknown-pragmas %s -lm -o %t/original
   RUN: %t/original > %t/expected && %t/swapped | diff - %t/expected
*/
#include <stdio.h>

#ifdef MAIN_ONLY
void scaled_sum(const double *x, double factor, double *sums);
#else
#pragma symreal function input(x[1:3]) parameter(factor) output(sums[0:2])
void scaled_sum(const double *x, double factor, double *sums) {
  sums[0] = factor * (x[1] + x[2]);
  sums[1] = factor * factor + x[3];
}
#endif

int main(void) {
  double x[4] = {100, 1, 2, 3}, sums[2];
  scaled_sum(x, 2.5, sums);
  printf("%.17g %.17g\n", sums[0], sums[1]);
  return 0;
}
