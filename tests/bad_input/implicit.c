/* What implicit(x, r) cannot take.
   RUN: rm -rf %t && mkdir %t
   RUN: not %symreal generate %s -o %t/k.c -- -DONE 2>&1 | FileCheck %s --check-prefix=ONE
   RUN: not %symreal generate %s -o %t/k.c -- -DCOUNT 2>&1 | FileCheck %s --check-prefix=COUNT
   RUN: not %symreal generate %s -o %t/k.c -- -DINPUT 2>&1 | FileCheck %s --check-prefix=INPUT
   RUN: not %symreal generate %s -o %t/k.c -- -DPLAIN 2>&1 | FileCheck %s --check-prefix=PLAIN
   RUN: not %symreal generate %s -o %t/k.c -- -DAPART 2>&1 | FileCheck %s --check-prefix=APART
   RUN: not test -e %t/k.c
*/
#include <math.h>

#pragma symreal function input(p[0:2]) output(y[0:1]) jacobian(y, p)
void k(double const *p, double *y) {
  double x = sqrt(p[0]), own[2] = {p[0], p[1]}, r[2] = {x * x - p[0], p[1]}, zero = 0.0;
  (void)r, (void)zero, (void)own;
#ifdef ONE
  // ONE: implicit.c:[[@LINE+1]]:17: error: implicit(x, r) names the numbers that were found, and the residual that is 0 there [SYM021]
#pragma symreal implicit(x)
#elif defined(COUNT)
  // COUNT: implicit.c:[[@LINE+1]]:29: error: implicit(x, r): 'r[0:2]' has 2 numbers, and 'x' has 1 [SYM026]
#pragma symreal implicit(x, r[0:2])
#elif defined(INPUT)
  // INPUT: implicit.c:[[@LINE+1]]:26: error: implicit(x, r): 'own[0]' is an input or a parameter: nothing was solved [SYM026]
#pragma symreal implicit(own[0], r[0])
#elif defined(PLAIN)
  // PLAIN: implicit.c:[[@LINE+1]]:29: error: implicit(x, r): 'zero' does not depend on 'x' [SYM026]
#pragma symreal implicit(x, zero)
#elif defined(APART)
  // APART: implicit.c:{{[0-9]+}}:{{[0-9]+}}: error: the residual in implicit(x, r) does not determine x: {{.*}} [SYM181]
#pragma symreal implicit(x, r[1])
#endif
  y[0] = x;
}

int main(void) {
  double const p[2] = {4.0, 1.0};
  double y[1];
  k(p, y);
  return 0;
}
