// A compiler evaluates a call of the C library where it finds the argument constant, on one path as well, and rounds
// otherwise than the library: there the generated code hides the argument.
// RUN: %symreal generate %s -o %t.c --decisions=select
// RUN: FileCheck %s < %t.c
// RUN: gcc -std=c99 -O2 -ffp-contract=off -fno-tree-slp-vectorize -S -o %t.s %t.c
// RUN: FileCheck %s --check-prefix=CALLS < %t.s
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c --seed 3
// In mode fast nothing is hidden.
// RUN: %symreal generate %s -o %t.fast.c --decisions=select --fp=fast && not grep at_run %t.fast.c
#include <math.h>
#include <stdio.h>

// CHECK: static double at_run(double x) {
// CHECK-DAG: cbrt(at_run(
// CHECK-DAG: exp(at_run(
// CHECK-DAG: hypot(at_run({{[a-z0-9]+}}), 2.5)
// CHECK-DAG: hypot({{[a-z0-9]+}}, input[3])
// CHECK-DAG: sin(at_run(input[1]))
// CHECK-DAG: log(input[2])
// CHECK-DAG: sqrt({{[a-z0-9]+}})
// Nothing of it was evaluated: each value of y comes from a call.
// CALLS-COUNT-6: {{(call|jmp)}}{{.*}}{{cbrt|exp|hypot|sin|log}}
#pragma symreal function input(x[0:4]) range(0.5, 3) output(y[0:7])
void kernel(double const *x, double *y) {
  double const chosen = x[0] > 1.2 ? 1.5 : x[0];
  y[0] = cbrt(chosen);
  y[1] = exp(2 * chosen + 0.25);
  y[2] = hypot(chosen, 2.5);
  y[3] = hypot(chosen, x[3]);
  y[4] = x[1] == 1.5 ? x[0] : sin(x[1]);
  y[5] = log(x[2]);
  y[6] = sqrt(chosen);
}
int main(void) {
  double x[4] = {1.5, 1.5, 2.5, 0.75}, y[7];
  kernel(x, y);
  printf("%g\n", y[0]);
  return 0;
}
