/* A loop of the source is a loop of the generated code, however long it is: the state is carried, coefficients that differ
   are a table, and results are copied when all inputs are read.
   RUN: rm -rf %t && mkdir %t
   RUN: %symreal generate %s --reroll -o %t/long.c --mainline --map %t/long.json 2>&1 | FileCheck %s --check-prefix=SAID
   SAID: compute: 1 loop holds {{[0-9]+}} of {{[0-9]+}} operations
   RUN: FileCheck %s --input-file=%t/long.c
   CHECK: "no-tree-vectorize"
   CHECK: static void compute_[[LOOP:[0-9]+]](double const *input, double *restrict v) {
   CHECK: static double const values_5[5] = {
   CHECK: double c[[STATE:[0-9]+]] = v[{{[0-9]+}}];
   CHECK: for (int k = 0; k < {{19[0-9]}}; ++k) {
   CHECK-NEXT: double const *const row = values_5 + k % 5;
   CHECK: input[k + {{[0-9]+}}]
   CHECK: v[{{.*}}k{{.*}}] =
   CHECK-NEXT: c[[STATE]] =
   CHECK-NEXT: }
   CHECK: static void compute_{{[0-9]+}}(double const *v, double *restrict output) {
   CHECK-NEXT: for (int k = 0;
   CHECK: void compute(double const *input, double const *constants, double *output) {
   CHECK-NEXT: (void)constants;
   CHECK-NEXT: double v[
   CHECK: compute_[[LOOP]](input, v);

   RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -O1 -ffp-contract=off %t/long.c %t/long_main.c -lm -o %t/run
   RUN: %cc -w %s -o %t/original
   RUN: %t/run | sed 's/.*= //' > %t/generated.txt
   RUN: %t/original | diff - %t/generated.txt
   RUN: %symreal verify %s %t/long.c --samples=100 2>&1 | FileCheck %s --check-prefix=SAME
   SAME: mode finite: 100 samples, 100 within the premises
   SAME: y{{\[0\]}} {{ *}}200 {{ *}}0 {{ *}}0{{$}}
   RUN: %symreal generate %s --reroll --fp=strict -o %t/strict.c
   RUN: grep "k < 19" %t/strict.c
   RUN: %symreal verify %s %t/strict.c --samples=100 --min-samples=10 2>&1 | FileCheck %s --check-prefix=STRICT
   STRICT: mode strict: 100 samples

   In C++, and in single precision.
   RUN: %symreal generate %s --reroll --lang=cpp -o %t/long.cpp
   RUN: grep "k < 19" %t/long.cpp
   RUN: %symreal verify %s %t/long.cpp --samples=100 --min-samples=10 2>&1 | FileCheck %s --check-prefix=CPP
   CPP: mode finite: 100 samples, 100 within the premises
   CPP: y{{\[0\]}} {{ *}}200 {{ *}}0 {{ *}}0{{$}}
   RUN: %symreal generate %s --reroll --real=float -o %t/float.c
   RUN: grep "k < 19" %t/float.c
   RUN: %symreal verify %s %t/float.c --samples=100 --min-samples=10

   A fault is found.
   RUN: sed 's/= values_5 + k % 5/= values_5 + k % 4/' %t/long.c > %t/wrong.c && cp %t/long.h %t/wrong.h
   RUN: not %symreal verify %s %t/wrong.c --samples=100 --min-samples=10 2>&1 | FileCheck %s --check-prefix=WRONG
   WRONG: error: {{.*}} differ from the original [SYM{{.*}}]
*/
#include <stdio.h>

enum { samples = 200 };

#pragma symreal function input(x[0:200]) output(y[0:200])
void filter(double const *x, double *y) {
  static double const gain[5] = {0.25, 0.5, 0.125, 0.75, 0.375};
  double state = 0;
  for (int k = 0; k < samples; ++k) {
    state = state * 0.5 + gain[k % 5] * x[k];
    y[k] = state;
  }
}

int main(void) {
  double x[samples], y[samples];
  for (int k = 0; k < samples; ++k) x[k] = 1.0 / (k + 1);
  filter(x, y);
  for (int k = 0; k < samples; ++k) printf("%.17g\n", y[k]);
}
