// A pragma that sets the rounding mode: compilers that know it obey.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdio>

#pragma symreal function input(x) output(return)
double third(double x) {
  // CHECK: fenv_round.cpp:[[@LINE+1]]:{{[0-9]+}}: error: {{.*}}FENV_ROUND FE_UPWARD{{.*}}[SYM146]
#pragma STDC FENV_ROUND FE_UPWARD
  return x / 3;
}

int main() { std::printf("%g\n", third(1.0)); }
