/* An option that changes arithmetic, and whose text stands in no file of the roots: the reference would have it too. */
// RUN: rm -rf %t && mkdir -p %t/lib %t/src && cp %s %t/src/kernel.c
// RUN: echo '#define LIBRARY_FAST __attribute__((optimize("fast-math")))' > %t/lib/fast.h
// RUN: not %symreal generate %t/src/kernel.c -o %t/out.c -- -I%t/lib -DCONTRACTED='_Pragma("STDC FP_CONTRACT ON")' 2>&1 \
// RUN:   | FileCheck %s --implicit-check-not="error:"
// RUN: not ls %t/out.c
#include "fast.h"
#include <stdio.h>

#define TEXT(...) #__VA_ARGS__
// CHECK-DAG: kernel.c:[[@LINE+1]]:25: error: optimize("fast-math") changes arithmetic, and its text stands in no file of the roots [SYM206]
__attribute__((optimize(TEXT(fast-math)))) static double made(double a, double b) { return (a + b) - a; }
// CHECK-DAG: kernel.c:[[@LINE+1]]:1: error: optimize("fast-math") changes arithmetic, and its text stands in no file of the roots [SYM206]
LIBRARY_FAST static double fast(double a, double b) { return (a + b) - a; }
// CHECK-DAG: kernel.c:[[@LINE+1]]:1: error: #pragma STDC FP_CONTRACT ON changes arithmetic, and its text stands in no file of the roots [SYM206]
CONTRACTED

#pragma symreal function input(x, y) output(return)
double kernel(double x, double y) { return made(x, y) + fast(x, y); }

int main(void) { printf("%g\n", kernel(0.1, 1e9)); return 0; }
