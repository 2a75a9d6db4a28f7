/* C lets an expression or a parameter define a structure, C++ does not. */
// RUN: not %rewrite %s 2>&1 | FileCheck %s
#include <stddef.h>

// CHECK: types_in_expressions.c:[[@LINE+1]]:{{[0-9]+}}: {{.*}}a structure or enumeration is defined within an expression or a parameter [SYM037]
double size(double x) { return x * sizeof(struct { char c; double v; }); }
#define ALIGNMENT(type) offsetof(struct { char c; type v; }, v)
// CHECK: types_in_expressions.c:[[@LINE+1]]:{{[0-9]+}}: {{.*}}defined within an expression
double alignment(double x) { return x * ALIGNMENT(double); }
// CHECK: types_in_expressions.c:[[@LINE+1]]:{{[0-9]+}}: {{.*}}defined within an expression
double bits(double x) { return ((union { double d; unsigned long long u; }){x}).u & 1; }
