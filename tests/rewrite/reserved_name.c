// Names that begin with SYMREAL_ are the rewriter's alone; REAL and the others need not be free (type_name.cpp).
// RUN: not %rewrite %s 2>&1 | FileCheck %s
// CHECK-DAG: reserved_name.c:[[@LINE+1]]:9: error: 'SYMREAL_REAL' is a name of the source already [SYM038]
#define SYMREAL_REAL double
// CHECK-DAG: reserved_name.c:[[@LINE+1]]:8: error: 'SYMREAL_C' is a name of the source already [SYM038]
double SYMREAL_C;
// CHECK-NOT: 'REAL'
double REAL;
