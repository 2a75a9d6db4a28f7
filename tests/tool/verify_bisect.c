// --bisect names the pass that is the first to change an output, and in it the rewrite with its place.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/k.c --fp=fast
// RUN: python3 %tools/expect_status.py 3 %symreal verify --samples=100 --min-samples=10 %s %t/k.c --tol 1e-18 --bisect 2>&1 | FileCheck %s --check-prefix=PASS
// PASS: note: bisection: pass recover is the first to change an output: y[1] from {{.*}} to {{[^;]*$}}
// A file that was edited is not the work of a pass.
// RUN: %symreal generate %s -o %t/k.c
// RUN: sed 's/nextafter(input.0./nextafter(input[1]/' %t/k.c > %t/edited.c
// RUN: python3 %tools/expect_status.py 3 %symreal verify --samples=100 --min-samples=10 %s %t/edited.c --bisect 2>&1 | FileCheck %s --check-prefix=EDITED
// EDITED: note: bisection: no pass of the usual ones changes an output there
#include <math.h>
#include <stdio.h>
#pragma symreal function input(x[0:2]) range(1, 2) output(y[0:2])
void k(double const *x, double *y) {
  y[0] = nextafter(x[0], 3); // no extended precision judges a graph with this
  y[1] = (x[0] + x[1]) - x[1];
}
int main(void) {
  double x[2] = {1.5, 1.25}, y[2];
  k(x, y);
  printf("%g\n", y[0]);
  return 0;
}
