/* Functions of <tgmath.h> of numbers in single precision, and the kind that a type has.
   RUN: %rewrite %s -- | FileCheck %s
   RUN: %same %s --
   RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=50 --min-samples=20 2>&1 | FileCheck %s --check-prefix=VERIFY
   VERIFY: value_return {{ *}}1 {{ *}}0 {{ *}}0
*/
#include <stdio.h>
#include <tgmath.h>

struct pair {
  double a, b;
};

#pragma symreal function input(x) output(return)
double mixed(double x)
{
  float f = 0.3f, g = 1.7f;
  long double wide = 0.3L;
  int n = 3;
  /* CHECK: REAL y = x + REAL_EITHER((sin), ::std::sin)(f) * exp(x)
     CHECK: y += REAL_EITHER((pow), ::std::pow)(f, g) + pow(x, f) + REAL_EITHER((pow), ::std::pow)(f, n) + sqrt(n);
     CHECK: y += REAL_EITHER((fma), ::std::fma)(f, g, f)
   */
  double y = x + sin(f) * exp(x);
  y += pow(f, g) + pow(x, f) + pow(f, n) + sqrt(n);
  y += fma(f, g, f) + fmax(f, g) * atan2(g, f) + lrint(g) + ldexp(f, n) + fmax(f, n);
  y += (double)(cbrt(wide) - (long double)cbrt((double)wide));
  y += sizeof(log(f)) + sizeof(log(n)) + sizeof(hypot(f, g)) + sizeof(hypot(f, x));
  struct pair p = {1, 2};
  y += 3 * __builtin_classify_type(x) + 5 * __builtin_classify_type(x > 0) + 7 * __builtin_classify_type(f > g);
  y += 11 * __builtin_classify_type(p) + 13 * __builtin_classify_type(&p) + 17 * __builtin_classify_type((int)2.5);
  return y + p.a * p.b;
}

int main(void)
{
  printf("%.17g\n", mixed(0.7));
  return 0;
}
