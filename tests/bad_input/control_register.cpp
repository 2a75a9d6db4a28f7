// The register of x86 behind the modes, under its own names.
// REQUIRES: x86_64-linux
// RUN: %same %s
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdio>
#include <xmmintrin.h>

#pragma symreal function input(x) output(return)
double tiny(double x) {
  // CHECK: control_register.cpp:[[@LINE+1]]:3: error: the kernel uses {{.*}}, which {{.*}} [SYM144]
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  double const y = x * 1e-300;
  // CHECK: control_register.cpp:[[@LINE+1]]:3: error: the kernel uses _mm_setcsr, which sets the floating-point flags and modes [SYM144]
  _mm_setcsr(0x1f80);
  return y;
}

int main() { std::printf("%g\n", tiny(1e-10)); }
