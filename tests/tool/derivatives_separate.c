// --separate: the kernel as it is, and its derivatives as a function of their own; both can be linked, and each is verified.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/k.c --separate --wrapper --lang=c,cpp
// RUN: FileCheck %s --check-prefix=VALUE --input-file=%t/k.h
// VALUE-NOT: "derivatives"
// VALUE: double y[2];
// VALUE-NOT: jacobian
// RUN: FileCheck %s --check-prefix=ALONE --input-file=%t/k_derivatives.h
// ALONE: "derivatives":["jacobian(y, x, sparse)","gradient(cost)"],"separate":true
// ALONE: typedef struct k_derivatives_output_values {
// ALONE-NEXT: double jacobian_y_x[3];
// ALONE-NEXT: double gradient_cost[3];
// ALONE-NEXT: } k_derivatives_output_values;
// ALONE: enum { k_derivatives_jacobian_y_x_rows = 2
// ALONE: void k_derivatives_compute(
// RUN: cc -std=c99 -Wall -Wextra -Werror -shared -fPIC %t/k.c %t/k_derivatives.c %t/k_wrapper.c -lm -o %t/both.so
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/k.c %t/k_derivatives.c 2>&1 | FileCheck %s
// CHECK: y[{{[01]}}] {{ *}}2 {{ *}}0 {{ *}}0
// CHECK: kernel k, mode finite
// CHECK-NOT: output {{ *}}elements
// CHECK: jacobian_y_x[{{.*}}] {{ *}}6 {{.*}} 0 {{ *}}{{[0-9]+}} of
// CHECK-NEXT: gradient_cost[{{.*}}] {{ *}}3 {{.*}} 0 {{ *}}{{[0-9]+}} of
// RUN: sed 's/cos(/sin(/' %t/k_derivatives.c > %t/wrong.c && cp %t/k_derivatives.h %t/wrong.h
// RUN: sed -i 's/k_derivatives.h/wrong.h/' %t/wrong.c
// RUN: not %symreal verify --samples=100 --min-samples=10 %s %t/wrong.c 2>&1 | FileCheck %s --check-prefix=WRONG
// WRONG: elements of derivatives differ from those of the original [SYM091]
// Without it one function computes both, and shares their work.
// RUN: %symreal generate %s -o %t/one.c && FileCheck %s --check-prefix=ONE --input-file=%t/one.h
// ONE: double y[2];
// ONE: double jacobian_y_x[3];
// It is a word for derivatives.
// RUN: not %symreal generate %S/Inputs/no_derivatives.c -o %t/e.c --separate 2>&1 | FileCheck %s --check-prefix=NONE
// NONE: error: --separate needs derivatives of 'k': name them with --differentiate
// RUN: not ls %t/e.c
#include <math.h>
#include <stdio.h>

#pragma symreal function input(x[0:3]) range(-2, 2) output(y[0:2], cost[0:1]) jacobian(y, x, sparse) gradient(cost)
void k(double const *x, double *y, double *cost) {
  y[0] = sin(x[0]) * x[1];
  y[1] = x[2] * x[2];
  cost[0] = y[0] + y[1];
}

int main(void) {
  double x[3] = {0.5, 1.25, -0.75}, y[2], cost[1];
  k(x, y, cost);
  printf("%g %g %g\n", y[0], y[1], cost[0]);
  return 0;
}
