/* Where a guard does not hold, the wrapper calls the original, compiled under another name.
   RUN: rm -rf %t && mkdir %t
   RUN: %symreal generate %s -o %t/d.c --wrapper --prefix=damped --decisions=guard
   RUN: FileCheck %s < %t/d_wrapper.c
   CHECK: double damped_fallback(const double *x, double factor);
   CHECK: if (damped_compute(symreal_input, symreal_constants, symreal_output) != 0) return damped_fallback(x, factor);
   DEFINE: %{c} = %cc -std=c99 -Wall -Wextra -pedantic -Werror -Wno-unknown-pragmas
   RUN: %{c} -c -DFUNCTION -Ddamped=damped_fallback %s -o %t/original.o
   RUN: %{c} -DMAIN %s %t/d.c %t/d_wrapper.c %t/original.o -lm -o %t/swapped
   RUN: %{c} -DMAIN -DFUNCTION %s -lm -o %t/original
   RUN: %t/original > %t/expected && %t/swapped | diff - %t/expected
   RUN: FileCheck %s --check-prefix=VALUES < %t/expected
   VALUES: 5
   VALUES-NEXT: -3
*/
#include <stdio.h>

#if !defined MAIN && !defined FUNCTION
#define MAIN
#define FUNCTION
#endif

#ifdef FUNCTION
#pragma symreal function input(x[0:2]) parameter(factor) output(return)
double damped(const double *x, double factor) {
  if (x[0] < 0) return x[0] - x[1];
  return x[0] * factor + x[1];
}
#else
double damped(const double *x, double factor);
#endif

#ifdef MAIN
int main(void) {
  double x[2] = {1, 3};
  printf("%.17g\n", damped(x, 2));
  x[0] = -1;
  x[1] = 2;
  printf("%.17g\n", damped(x, 2));
  return 0;
}
#endif
