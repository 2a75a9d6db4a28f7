// A bit-field that is narrower than int is an int beside an integer that is computed from real numbers, in C++ and in C; but
// in `a /= o.g` of C++ g++ takes the type that it is declared with.
// RUN: rm -rf %t && mkdir %t && cp %s %t/k.c
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s
// RUN: %rewrite %t/k.c | grep 'a /= REAL_ONLY((int)) o.g;'
// RUN: %symreal generate %s --decisions=select -o %t/k_cpp.c && %symreal verify --samples=100 --min-samples=10 %s %t/k_cpp.c
// RUN: %symreal generate %t/k.c --decisions=select -o %t/k_c.c && %symreal verify --samples=100 --min-samples=10 %t/k.c %t/k_c.c
#include <stdio.h>

struct fields { double a; unsigned g : 8; unsigned long h : 20; unsigned all : 32; int s : 5; };

#pragma symreal function input(x[0:2]) range(-100.0, 100.0) output(y[0:8])
void k(double const *x, double *y) {
  struct fields o = {x[0], 6, 9, 5, -3};
  int a = (int)x[1], n = (int)x[0];
  long l = (long)x[1];
  // CHECK: ((REAL_INT(short)){{.*}} - REAL_ONLY((int)) o.g) * 1e-3;
  y[0] = ((short)x[1] - o.g) * 1e-3;
  y[1] = a - o.g < 0 ? 1 : 2;
  y[2] = (a * o.h < -5) + (o.g > n) * 2 + (a + o.all > 7) * 4 + (o.s - a) * 8.0;
  // CHECK: a /= o.g;
  a /= o.g;
  y[3] = a + (o.g << (n & 3)) * 1e-3 - (-n & o.g);
  y[4] = (l + o.h) / 2 + (o.h - l) % 7;
  n += o.g;
  n %= o.h;
  y[5] = n + ((o.g) - n) * 0.5;
  y[6] = (x[0] > 1) - o.g;
  y[7] = -o.g * x[0] + (o.g | n) * 0.25;
}

int main(void) {
  double x[2] = {1.5, 2.5}, y[8];
  k(x, y);
  for (int i = 0; i < 8; i++) printf("%g\n", y[i]);
  return 0;
}
