/* Several kernels in one file that need copies of it have one each: the generated functions have the same names.
   RUN: rm -rf %t && mkdir %t && cd %t
   RUN: %symreal generate %s -o . --wrapper --decisions=guard 2>&1 | FileCheck %s
   CHECK-DAG: the wrapper of 'pair_of' is a copy of its file, {{.*}}: compile ./pair_of_wrapper.c in place of
   CHECK-DAG: the wrapper of 'larger' is a copy of its file, {{.*}}: compile ./larger_wrapper.c in place of
   DEFINE: %{name} =
   DEFINE: %{swap} = cd %t && %cc -std=c99 -Wall -Wextra -pedantic -Werror -Wno-unknown-pragmas %{name}.c %{name}_wrapper.c -lm -o swapped && ./swapped | diff - expected
   RUN: cd %t && %cc %s -lm -o original && ./original > expected
   REDEFINE: %{name} = pair_of
   RUN: %{swap}
   REDEFINE: %{name} = larger
   RUN: %{swap}
   RUN: cd %t && %symreal verify %s pair_of.c larger.c --samples=50 --min-samples=5 2>&1 | FileCheck %s --check-prefix=VERIFY
   VERIFY: the wrapper was tried as well
   VERIFY: the wrapper was tried as well
*/
#include <math.h>
#include <stdio.h>

struct pair {
  double first, second;
};

#pragma symreal function input(x) output(return)
struct pair pair_of(double x) {
  struct pair made;
  made.first = sin(x);
  made.second = x * x;
  return made;
}

#pragma symreal function input(p) output(return)
struct pair larger(struct pair p) {
  struct pair made = p;
  if (p.first > p.second) made.second = p.first;
  made.first = 2 * p.second;
  return made;
}

int main(void) {
  double x;
  for (x = -1; x < 2; x += 0.25) {
    struct pair a = pair_of(x), b = larger(a);
    printf("%.17g %.17g %.17g %.17g\n", a.first, a.second, b.first, b.second);
  }
  return 0;
}
