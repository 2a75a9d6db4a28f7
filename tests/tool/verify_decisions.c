// Beside the samples that are drawn, verify tries neighbours on both sides of each decision's boundary, also of one that
// no drawn sample comes to. It says which decisions went one way only.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/k.c --decisions=select
// RUN: %symreal verify %s %t/k.c --json > %t/json 2> %t/told
// RUN: FileCheck %s --check-prefix=TOLD < %t/told
// RUN: FileCheck %s --check-prefix=JSON < %t/json
// TOLD: kernel k, mode finite: 1000 samples and {{[1-9][0-9]*}} around decisions, {{[0-9]+}} within the premises
// TOLD: decisions: 3 of 4 went both ways; samples stand on both sides of the boundaries of 3
// TOLD-NEXT: verify_decisions.c:[[#@LINE + 22]]: always true, in {{[0-9]+}} samples
// JSON: "around": {{[1-9]}}
// JSON: "decisions": [
// JSON: "place": "verify_decisions.c:{{[0-9]+}}",
// JSON-NEXT: "of": "select",
// JSON-NEXT: "yes": {{[1-9][0-9]*}},
// JSON-NEXT: "no": {{[1-9][0-9]*}}
// One side is reached by chance, the boundary is not.
// RUN: sed 's/input.0. > 0.3 /input[0] >= 0.3 /' %t/k.c > %t/boundary.c
// RUN: python3 %tools/expect_status.py 3 %symreal verify %s %t/boundary.c 2>&1 | FileCheck %s --check-prefix=BOUNDARY
// BOUNDARY: error: 1 of 4 outputs differ from the original [SYM091]
// BOUNDARY: note: y[0]: original 1, generated 2, {{.*}} inputs 0.3,
// One side is not reached by chance.
// RUN: sed 's/123456.75/654321.75/' %t/k.c > %t/far.c
// RUN: python3 %tools/expect_status.py 3 %symreal verify %s %t/far.c 2>&1 | FileCheck %s --check-prefix=FAR
// FAR: note: y[1]: original 123456.75
#include <stdio.h>
#pragma symreal function input(x[0:2]) range(0.25, 4) output(y[0:4])
void k(double const *x, double *y) {
  y[0] = x[0] > 0.3 ? 2 : 1;
  y[1] = x[0] * x[1] >= 15.9999999 ? 123456.75 : x[1];
  y[2] = x[1] - x[0] < -1 ? x[0] : 1;
  y[3] = x[1] < 5 ? x[0] : x[1];
}
int main(void) {
  double x[2] = {0.5, 0.75}, y[4];
  k(x, y);
  printf("%g\n", y[0]);
  return 0;
}
