// Sparse matrices of many inputs are verified along few directions: inputs that no addend of an output has two of move at once. Each
// element is still judged by itself, also those that are zero by structure, and the dense rows and columns of an arrow.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/k.c
// RUN: %symreal verify %s %t/k.c --samples=40 2>&1 | FileCheck %s
// CHECK: derivative {{ *}}elements {{ *}}worst error/allowed {{ *}}different {{ *}}samples judged
// CHECK-NEXT: jacobian_y_total_x[{{.*}}] {{ *}}3600 {{ *}}0{{(\.[0-9]+)?(e-[0-9]+)?}} {{ *}}0 {{ *}}{{[0-9][0-9]}} of {{[0-9]+$}}
// CHECK-NEXT: gradient_total[{{.*}}] {{ *}}60 {{ *}}0{{.*}} 0 {{ *}}{{[0-9][0-9]}} of
// CHECK-NEXT: hessian_total_x[{{.*}}] {{ *}}3600 {{ *}}0{{.*}} 0 {{ *}}{{[0-9][0-9]}} of
// CHECK-NEXT: hessian_y_x[{{.*}}] {{ *}}3600 {{ *}}0{{.*}} 0 {{ *}}{{[0-9][0-9]}} of
// An element that is not there, and elements of one row that have changed places, are found and named.
// RUN: cp %t/k.h %t/zero.h && sed 's/output\[70\] = .*/output[70] = 0.0;/' %t/k.c > %t/zero.c
// RUN: not %symreal verify %s %t/zero.c --samples=40 2>&1 | FileCheck %s --check-prefix=ZERO
// ZERO: error: 1 of 10860 elements of derivatives differ from those of the original [SYM091]
// ZERO-NEXT: note: jacobian_y_total_x[{{[0-9]+}}][{{[0-9]+}}]: dual numbers give {{.*}}, generated 0, inputs
// RUN: cp %t/k.h %t/moved.h && sed 's/output\[70\] = /output[QQQ] = /; s/output\[71\] = /output[70] = /; s/QQQ/71/' %t/k.c > %t/moved.c
// RUN: not %symreal verify %s %t/moved.c --samples=40 2>&1 | FileCheck %s --check-prefix=MOVED
// MOVED: error: 2 of 10860 elements of derivatives differ from those of the original [SYM091]
#include <math.h>

enum { N = 60 };

#pragma symreal function input(x[0:N]) range(-3, 3) output(y[0:N-1], total[0:1]) jacobian([y, total], x, sparse) gradient(total) hessian(total, x, sparse) hessian(y, x, weighted, sparse, symmetric)
void chain(double const *x, double *y, double *total) {
  *total = 0;
  for (int i = 0; i + 1 < N; i++) {
    double const a = x[i + 1] - x[i] * x[i];
    y[i] = (3 - 2 * x[i]) * x[i] - 2 * x[i + 1] + sin(x[i] * x[i + 1]) + x[0] * x[i];
    *total += 100 * a * a + fmax(x[i], 0.25) * exp(x[0]);
  }
}

int main(void) {
  double x[N], y[N - 1], total;
  for (int i = 0; i < N; i++) x[i] = 0.5 + 0.01 * i;
  chain(x, y, &total);
  return 0;
}
