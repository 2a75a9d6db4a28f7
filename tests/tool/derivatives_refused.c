// What cannot be differentiated is an error, and what jumps a warning with its place.
// RUN: rm -rf %t && mkdir %t
// RUN: not %symreal generate %s -o %t/k.c --differentiate 'jacobian(w, x)' 2>&1 | FileCheck %s --check-prefix=OUTPUT
// OUTPUT: error: --differentiate 'jacobian(w, x)': 'w' is not an output of the kernel, which has y, g, s [SYM180]
// RUN: not %symreal generate %s -o %t/k.c --differentiate 'jacobian(y, [x, y])' 2>&1 | FileCheck %s --check-prefix=INPUT
// INPUT: error: --differentiate 'jacobian(y, [x, y])': 'y' is not an input of the kernel, which has x [SYM180]
// RUN: not %symreal generate %s -o %t/k.c --differentiate 'jacobian(y, [x, x])' 2>&1 | FileCheck %s --check-prefix=TWICE
// TWICE: 'x' stands there twice [SYM180]
// RUN: not %symreal generate %s -o %t/k.c --differentiate 'slope(y, x)' 2>&1 | FileCheck %s --check-prefix=KIND
// KIND: this is not one of jacobian(y, x), gradient(y), hessian(y, x), jvp(y, x) and vjp(y, x) [SYM180]
// RUN: not %symreal generate %s -o %t/k.c --differentiate 'hessian(y, x)' 2>&1 | FileCheck %s --check-prefix=VECTOR
// VECTOR: derivatives_refused.c:[[@LINE+28]]:{{[0-9]+}}: error: --differentiate 'hessian(y, x)': what is named has 2 numbers [SYM183]
// RUN: not %symreal generate %s -o %t/k.c --differentiate 'gradient(g)' 2>&1 | FileCheck %s --check-prefix=GAMMA
// GAMMA: derivatives_refused.c:[[@LINE+18]]:{{[0-9]+}}: error: 'tgamma' has no derivative that gradient_g could go through [SYM181]
// RUN: not %symreal generate %s -o %t/k.c --wrapper --differentiate 'gradient(g)' 2>&1 | FileCheck %s --check-prefix=WRAPPER
// WRAPPER: error: --wrapper defines the original's function, which has no place for derivatives
// RUN: not ls %t/k.c
// RUN: %symreal generate %s -o %t/k.c --differentiate 'gradient(s)' 2>&1 | FileCheck %s --check-prefix=JUMP
// JUMP: derivatives_refused.c:[[@LINE+14]]:{{[0-9]+}}: warning: gradient_s leads through 'floor', which jumps [SYM182]
// It is the slope between the jumps, and verified there.
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/k.c
// What verification cannot see is not passed over: code in single precision.
// RUN: %symreal generate %s -o %t/single.c --real=float --differentiate 'jacobian(y, x)'
// RUN: not %symreal verify --samples=100 --min-samples=10 %s %t/single.c 2>&1 | FileCheck %s --check-prefix=SINGLE
// SINGLE: error: the derivatives cannot be checked: the code is in single precision [SYM184]
#include <math.h>
#include <stdio.h>

void k(double const *x, double *y, double *g, double *s) {
  y[0] = x[0] * x[1];
  y[1] = x[0] + x[1];
  *g = x[0] * tgamma(x[1]);
  *s = x[0] * floor(x[1]);
}

int main(void) {
  double x[2] = {0.5, 1.25}, y[2], g, s;
#pragma symreal input(x[0:2]) range(0.1, 9)
  k(x, y, &g, &s);
#pragma symreal output(y[0:2]) output(g) output(s) generate("k.c")
  printf("%g %g %g %g\n", y[0], y[1], g, s);
  return 0;
}
