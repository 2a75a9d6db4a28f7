// A variable that anyone may set is read, but named in no pragma: it would be baked in.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

double gain = 2.5;

#pragma symreal function input(x) output(return)
double amplify(double x) { return gain * std::sin(x); }

int main() {
  std::printf("%g\n", amplify(0.5));
  gain = 3.5;
  std::printf("%g\n", amplify(0.5));
}

// CHECK: undeclared_global.cpp:8:{{[0-9]+}}: error: {{.*}}gain{{.*}}[SYM017]
// CHECK: help:
