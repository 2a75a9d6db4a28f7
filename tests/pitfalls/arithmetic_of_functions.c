/* An option in an attribute or a pragma that changes arithmetic is left out, of the reference as well. In numeric mode it
   stays, and verify says how far it moves the original. */
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s --check-prefix=TEXT
// RUN: %rewrite %s > %t.rewritten.c && %rewrite %t.rewritten.c | diff %t.rewritten.c -
// RUN: %symreal generate %s -o %t.c 2>&1 -- -O2 | FileCheck %s --implicit-check-not="SYM205"
// RUN: %symreal verify %s %t.c --samples=200 -- -O2 2>&1 | FileCheck %s --check-prefix=VERIFY
#include <stdio.h>

// TEXT: __attribute__((noinline, optimize(REAL_EITHER(("O2,fast-math"), "O2"))))
// CHECK-DAG: arithmetic_of_functions.c:[[@LINE+1]]:35: warning: optimize("O2,fast-math") is left out, of the reference as well: it changes arithmetic [SYM205]
__attribute__((noinline, optimize("O2,fast-math"))) static double rounded(double a, double b) { return (a + b) - a; }
// TEXT: #define FAST __attribute__((__optimize__(REAL_EITHER(("-ffast-math"), "no-fast-math"), "unroll-loops")))
#define FAST __attribute__((__optimize__("-ffast-math", "unroll-loops")))
// CHECK-DAG: arithmetic_of_functions.c:[[@LINE+1]]:1: warning: optimize("-ffast-math") is left out, of the reference as well: it changes arithmetic [SYM205]
FAST static double third(double a) { return a / 3 + a / 7; }
__attribute__((optimize("O3"))) static double kept(double a, double b) { return a * b + a; }
static double optimize(const char *how) { return how[0]; }

#pragma GCC push_options
// CHECK-DAG: arithmetic_of_functions.c:[[@LINE+2]]:{{[0-9]+}}: warning: #pragma GCC optimize ("O3", "unsafe-math-optimizations") is left out, of the reference as well: it changes arithmetic [SYM205]
// TEXT: REAL_EITHER((_Pragma("GCC optimize (\"O3\", \"unsafe-math-optimizations\")")), )
#pragma GCC optimize ("O3", \
                      "unsafe-math-optimizations") /* for speed */
static double fused(double a, double b) { return (a + b) - b; }
#pragma GCC pop_options
// CHECK-DAG: arithmetic_of_functions.c:[[@LINE+1]]:{{[0-9]+}}: warning: #pragma STDC FP_CONTRACT ON is left out, of the reference as well: it changes arithmetic [SYM205]
_Pragma("STDC FP_CONTRACT ON")
static double product(double a, double b) { return a * b + 1; }
#pragma STDC FP_CONTRACT OFF
#define DO_PRAGMA(words) _Pragma(#words)
#pragma GCC push_options
// CHECK-DAG: arithmetic_of_functions.c:[[@LINE+2]]:1: warning: #pragma GCC optimize "fast-math" is left out, of the reference as well: it changes arithmetic [SYM205]
// TEXT: REAL_EITHER((DO_PRAGMA(GCC optimize "fast-math")), )
DO_PRAGMA(GCC optimize "fast-math")
static double made(double a, double b) { return (a + b) - b; }
#pragma GCC pop_options
#if defined(__GNUC__) && !defined(__clang__) /* Clang, which reads the source, skips it */
// TEXT: #define QUICK __attribute__((optimize(REAL_EITHER(("fast-math"), "no-fast-math"))))
// CHECK-DAG: arithmetic_of_functions.c:[[@LINE+1]]:39: warning: optimize("fast-math") is left out, of the reference as well: it changes arithmetic [SYM205]
#define QUICK __attribute__((optimize("fast-math")))
#else
#define QUICK
#endif
QUICK static double quick(double a, double b) { return (a + b) - a; }
#pragma GCC optimize ("no-fast-math")

#pragma symreal function input(x, y) output(return)
double kernel(double x, double y) {
  return rounded(x, y) + third(x) + kept(x, y) + fused(x, y) + product(x, y) + made(x, y) + quick(x, y) +
         optimize("fast-math");
}
// VERIFY: output {{.*}}ULP, own flags
// VERIFY-NEXT: value_return 1 0 0 {{[1-9]}}

int main(void) { printf("%d %g\n", __LINE__, kernel(0.1, 1e9)); return 0; }
