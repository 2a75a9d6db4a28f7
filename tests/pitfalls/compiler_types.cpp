// Vector types of the compiler, intrinsics and assembly work on double: a REAL does not get there unseen.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdio>

typedef double Pair __attribute__((vector_size(16)));

#pragma symreal function input(x) output(return)
double sum(double x) {
  Pair pair = {x, 2.0};
  pair += pair;
  return pair[0] + pair[1];
}

int main() { std::printf("%g\n", sum(0.5)); }
// CHECK: compiler_types.cpp:{{[0-9]+}}:{{[0-9]+}}: error: {{.*}} [SYM0
