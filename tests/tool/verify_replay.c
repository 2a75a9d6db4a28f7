// The result says for which inputs an output is farthest off, in a first call and in later ones, and --replay tries just these again; or an input of one's
// own.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/k.c
// RUN: sed 's/sin(input.0.)/sin(input[0]*1.0000001)/' %t/k.c > %t/wrong.c
// RUN: not %symreal verify %s %t/wrong.c --json > %t/result.json 2> %t/told
// RUN: FileCheck %s --check-prefix=JSON < %t/result.json
// JSON: "name": "y[1]",
// JSON: "worst": {
// JSON-NEXT: "sample": {{[0-9]+}},
// JSON-NEXT: "original": {{[-.e0-9]+}},
// JSON-NEXT: "generated": {{[-.e0-9]+}},
// JSON-NEXT: "relative": {{[-.e0-9]+}}
// JSON: "named": [
// JSON: "inputs": [
// RUN: python3 %tools/expect_status.py 3 %symreal verify %s %t/wrong.c --replay %t/result.json 2> %t/again
// RUN: FileCheck %s --check-prefix=AGAIN < %t/again
// AGAIN: mode finite: {{[12] samples?}}, {{[12]}} within the premises
// RUN: grep 'y.1.: original' %t/told > %t/one && grep 'y.1.: original' %t/again | diff %t/one -
// RUN: %symreal verify %s %t/k.c --replay %t/result.json
// RUN: echo '{"inputs": [0.5, 2]}' > %t/own.json && python3 %tools/expect_status.py 3 %symreal verify %s %t/wrong.c --replay %t/own.json 2>&1 | FileCheck %s --check-prefix=OWN
// OWN: note: y[1]: original {{.*}} inputs 0.5, 2
// RUN: echo '{"inputs": [0.5]}' > %t/short.json && not %tool verify %s %t/k.c --replay %t/short.json 2>&1 | FileCheck %s --check-prefix=SHORT
// SHORT: short.json: error: kernel 'k' has 2 inputs and 0 parameters, a sample in this file has 1 and 0 [SYM109]
// RUN: %symreal verify %s %t/k.c --json > %t/equal.json && not %tool verify %s %t/k.c --replay %t/equal.json 2>&1 | FileCheck %s --check-prefix=EQUAL
// EQUAL: error: this file has no samples of kernel 'k': all outputs are equal in it [SYM109]
// RUN: not %tool verify %s %t/k.c --replay %s 2>&1 | FileCheck %s --check-prefix=NONE
// NONE: error: this file is not what verify --json prints [SYM109]
// RUN: not %tool verify %s %t/k.c --replay %t/own.json --seed 2 2>&1 | FileCheck %s --check-prefix=SEED
// SEED: error: --seed has no effect with --replay, which tries the samples of a file [SYM
#include <math.h>
#include <stdio.h>
#pragma symreal function input(x[0:2]) output(y[0:2])
void k(double const *x, double *y) {
  y[0] = x[0] * x[1];
  y[1] = sin(x[0]) + x[1];
}
int main(void) {
  double x[2] = {0.75, 0.5}, y[2];
  k(x, y);
  printf("%g\n", y[0]);
  return 0;
}
