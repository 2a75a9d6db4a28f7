// A name that the rewriter writes must be free.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
// CHECK: reserved_name.c:[[@LINE+1]]:9: error: 'REAL' is a name of the source already [SYM038]
#define REAL double
// CHECK: reserved_name.c:[[@LINE+1]]:8: error: 'REAL_C' is a name of the source already [SYM038]
double REAL_C;
