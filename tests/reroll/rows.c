// Chains through the same links, each one link longer than the one before: links become rows, which are one loop in
// another, and a chain keeps its place from row to row. gcc makes vectors of that loop, and fuses nothing. Where values
// between the links are read again, each link is a loop.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s --kernel moved --reroll -o %t/moved.c --mainline 2>&1 | FileCheck %s --check-prefix=LOOPS
// LOOPS: compute: {{[1-5]}} loops hold
// RUN: FileCheck %s --input-file=%t/moved.c
// CHECK: #define SYMREAL_SIDE_BY_SIDE __attribute__((optimize("tree-loop-vectorize")))
// CHECK: SYMREAL_SIDE_BY_SIDE static void compute_{{[0-9]+}}(double const *input, double *restrict v
// CHECK: for (int i = 0; i < {{[0-9]+}}; ++i) {
// CHECK-NEXT: double const [[S:f[0-9]+]] = input[{{[0-9]+}} - i];
// CHECK-NEXT: double const [[C:f[0-9]+]] = input[{{[0-9]+}} - i];
// CHECK-NEXT: for (int j = 0; j < i + {{[0-9]+}}; ++j) {
// CHECK-NEXT: double const y = v[j + [[CY:[0-9]+]]] - v[j + [[SX:[0-9]+]]];
// CHECK-NEXT: double const [[X:t[0-9]+]] = v[j + [[TURNED:[0-9]+]]] - y*0.25;
// CHECK: v[j + [[TURNED]]] = t
// CHECK-NEXT: v[j + [[CY]]] = t
// CHECK-NEXT: v[j + [[SX]]] = t
// CHECK-NEXT: v[k + {{[0-9]+}}] = [[X]];
// CHECK-NEXT: ++k;
// RUN: %symreal verify %s --kernel moved %t/moved.c --samples=100 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: 100 samples, 100 within the premises
// REQUIRES: x86_64-linux
// RUN: gcc -std=c99 -O3 -mavx2 -mfma -I%t -c %t/moved.c -o %t/moved.o
// RUN: objdump -d %t/moved.o | FileCheck %s --check-prefix=VECTORS
// VECTORS-NOT: vf{{n?m(add|sub)}}
// VECTORS: vmulpd {{.*}}%ymm
// VECTORS-NOT: vf{{n?m(add|sub)}}
// RUN: %symreal generate %s --kernel used --reroll -o %t/used.c 2>&1 | FileCheck %s --check-prefix=STAGES
// STAGES: compute: {{[2-4][0-9]}} loops hold
// RUN: %symreal verify %s --kernel used %t/used.c --samples=100 2>&1 | FileCheck %s --check-prefix=SAME
#include <stdio.h>

enum { links = 40 };

static void move(double c, double s, double *x, double *y) {
  double const turned = c * *x - s * *y;
  *y = s * *x + c * *y;
  *x = turned + 0.25 * *y;
}

#pragma symreal function input(c[0 : 40], s[0 : 40], f[0 : 40], g[0 : 40]) output(h[0 : 1600])
void moved(double const *c, double const *s, double const *f, double const *g, double *h) {
  for (int i = 0; i < links; ++i) {
    double x = f[i], y = g[i];
    for (int k = 0; k < links; ++k) h[links * i + k] = 0;
    for (int k = i; k >= 0; --k) {
      move(c[k], s[k], &x, &y);
      h[links * i + k] = x;
    }
  }
}

#pragma symreal function input(c[0 : 40], s[0 : 40], f[0 : 40], g[0 : 40]) output(h[0 : 40], *sum)
void used(double const *c, double const *s, double const *f, double const *g, double *h, double *sum) {
  double halfway[links] = {0};
  for (int i = 0; i < links; ++i) {
    double x = f[i], y = g[i];
    for (int k = i; k >= 0; --k) {
      move(c[k], s[k], &x, &y);
      if (k == i / 2) halfway[i] = y;
    }
    h[i] = x;
  }
  *sum = 0;
  for (int i = 0; i < links; ++i) *sum += halfway[i] * halfway[i];
}

int main(void) {
  double c[links], s[links], f[links], g[links], h[links * links], all[links], sum;
  for (int k = 0; k < links; ++k) c[k] = 0.8 - 0.01 * k, s[k] = 0.6 + 0.01 * k, f[k] = 1.0 / (k + 1), g[k] = 0.5;
  moved(c, s, f, g, h);
  used(c, s, f, g, all, &sum);
  printf("%.17g %.17g\n", h[1], sum);
}
