// A kernel calls an external function without the array that it takes.
// RUN: rm -rf %t && mkdir %t
// RUN: %cc -DBODY -c %s -o %t/body.o
// RUN: not %symreal generate %s --link=%t/body.o -o %t/weighted.c 2>&1 | FileCheck %s
// RUN: not ls %t/weighted.c
#include <stddef.h>

#ifdef BODY
double total(double const *x) { return x ? x[0] + x[1] : 0; }
#else
double total(double const *x);
#pragma symreal external(total) pure input(x[0:2])

#pragma symreal function input(x) output(return)
double weighted(double x) { return x * total(NULL); }

int main(void) { return weighted(0.5) > 1; }

// CHECK: external_null_pointer.c:15:{{[0-9]+}}: error: in the call of 'total' parameter 1 is a null pointer [SYM067]
// CHECK: help: declare another function for the other form of the call
#endif
