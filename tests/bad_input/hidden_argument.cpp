// An argument that is passed by value, and named in no pragma, is baked in like any other number.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cstdio>

struct Gains {
  double p, d;
  int order;
};

#pragma symreal function input(x, v) constant(gains.d) output(return)
double control(Gains gains, double x, double v, double dt) { return gains.p * x + gains.d * v / dt; }

int main() { std::printf("%g\n", control({2.0, 3.0, 1}, 0.5, 0.25, 0.01)); }

// CHECK: hidden_argument.cpp:13:22: error: kernel 'control' reads 'gains' (2, 1), which are neither input nor parameter [SYM017]
// CHECK: hidden_argument.cpp:13:56: error: kernel 'control' reads 'dt' (0.01), which is neither input nor parameter [SYM017]
// CHECK-NOT: SYM017]
