// A program that has changed how arithmetic rounds before its kernel begins, or that leaves it so: the promise is about
// rounding to nearest, with subnormal numbers.
// REQUIRES: x86_64-linux
// RUN: %same %s && rm -f %t.c
// RUN: not %symreal generate %s -o %t.c --run-args=up 2>&1 | FileCheck %s --check-prefix=UP
// RUN: not %symreal generate %s -o %t.c --run-args=flush 2>&1 | FileCheck %s --check-prefix=FLUSH
// RUN: not %symreal generate %s -o %t.c --run-args=sse 2>&1 | FileCheck %s --check-prefix=UP
// RUN: not %symreal generate %s -o %t.c --run-args=within 2>&1 | FileCheck %s --check-prefix=WITHIN
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c --run-args=nearest
#include <cfenv>
#include <cstdio>
#include <string_view>
#include <xmmintrin.h>

static bool within = false;

#pragma symreal function input(x) output(return) constant(within)
// UP: modes_at_entry.cpp:[[@LINE-1]]:{{[0-9]+}}: error: kernel 'third' begins where arithmetic does not round to nearest [SYM146]
// FLUSH: modes_at_entry.cpp:[[@LINE-2]]:{{[0-9]+}}: error: kernel 'third' begins where arithmetic takes subnormal numbers for zero [SYM146]
// WITHIN: modes_at_entry.cpp:[[@LINE-3]]:{{[0-9]+}}: error: kernel 'third' ends where arithmetic does not round to nearest [SYM146]
double third(double x) {
  if (within) {
    unsigned const up = 0x5f80 & ~0x80u; // by assembly, which nobody looks into; the exception that we need is kept
    asm volatile("ldmxcsr %0" : : "m"(up));
  }
  return x / 3;
}

int main(int, char **arguments) {
  std::string_view const what = arguments[1];
  if (what == "up") std::fesetround(FE_UPWARD);
  if (what == "sse") _MM_SET_ROUNDING_MODE(_MM_ROUND_UP);
  if (what == "flush") _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  within = what == "within";
  std::printf("%g\n", third(1.0));
}
