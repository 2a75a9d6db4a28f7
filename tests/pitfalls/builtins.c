/* Functions of the compiler, which take a double and nothing else. */
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: rm -rf %t && mkdir %t && cp %s %t/b.c && cd %t && %symreal generate b.c -o k.c && FileCheck %s --check-prefix=CODE < k.c && %symreal verify --samples=100 --min-samples=10 b.c k.c
// RUN: cd %t && %symreal rewrite b.c --out-root once && cd once && %symreal rewrite b.c --diff | count 0
#include <math.h>
#include <stdio.h>

#pragma symreal function input(x, y) range(1, 2) output(return)
double f(double x, double y) {
  // CHECK: REAL z = REAL_BUILTIN(sqrt)(x) + REAL_BUILTIN(fma)(x, y, 1.0) + REAL_BUILTIN(fmax)(x, y);
  double z = __builtin_sqrt(x) + __builtin_fma(x, y, 1.0) + __builtin_fmax(x, y);
  // CHECK: z += REAL_BUILTIN(copysign)(0.5, x) + (__builtin_huge_val() > 0);
  z += __builtin_copysign(0.5, x) + (__builtin_huge_val() > 0);
  return __builtin_fabs(z) + sin(__builtin_floor(x));
}
int main(void) {
  printf("%g\n", f(1.5, 1.25));
  return 0;
}
// CODE-DAG: sqrt(input[0])
// CODE-DAG: fma(input[0], input[1],
