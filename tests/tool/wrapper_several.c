/* Kernels of one file that need copies of it share one, and their generated functions have names of their own: one program
   has both.
   RUN: rm -rf %t && mkdir %t && cd %t
   RUN: %symreal generate %s -o . --wrapper --decisions=guard 2>&1 | FileCheck %s
   CHECK-DAG: the wrapper of 'pair_of' is a copy of its file, {{.*}}: compile ./pair_of_wrapper.c in place of
   CHECK-DAG: the wrapper of 'larger' is a copy of its file, {{.*}}: compile ./pair_of_wrapper.c in place of
   RUN: FileCheck %s --check-prefix=COPY < %t/pair_of_wrapper.c
   COPY: in which generated code stands before the bodies of pair_of, larger.
   COPY: pair_of_compute(symreal_input
   COPY: larger_compute(symreal_input
   RUN: cd %t && not ls larger_wrapper.c
   RUN: cd %t && %cc %s -lm -o original && ./original > expected
   RUN: cd %t && %cc -std=c99 -Wall -Wextra -pedantic -Werror -Wno-unknown-pragmas pair_of.c larger.c pair_of_wrapper.c -lm -o swapped && ./swapped | diff - expected
   RUN: cd %t && %symreal verify %s pair_of.c larger.c --samples=50 --min-samples=5 2>&1 | FileCheck %s --check-prefix=VERIFY
   VERIFY: the wrapper was tried as well
   VERIFY: the wrapper was tried as well

   A copy that hands over another number is refused for the kernel that it belongs to.
   RUN: cd %t && sed 's/= [(]p[)].second;/= (p).first;/' pair_of_wrapper.c > w && not diff w pair_of_wrapper.c && mv w pair_of_wrapper.c
   RUN: cd %t && %symreal verify %s pair_of.c --samples=50 --min-samples=5
   RUN: cd %t && not %symreal verify %s larger.c --samples=50 --min-samples=5 2>&1 | FileCheck %s --check-prefix=OTHER
   OTHER: pair_of_wrapper.c:1:1: error: this wrapper was generated for another form of kernel 'larger' [SYM090]
   RUN: cd %t && %symreal generate %s -o . --wrapper --decisions=guard && sed 's/(larger_compute/(pair_of_compute/' pair_of_wrapper.c > w && mv w pair_of_wrapper.c
   RUN: cd %t && not %symreal verify %s larger.c --samples=50 --min-samples=5 2>&1 | FileCheck %s --check-prefix=OTHER
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
