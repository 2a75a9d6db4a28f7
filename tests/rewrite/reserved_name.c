// Names that begin with SYMREAL_ are the rewriter's alone; REAL and the others need not be free (type_name.cpp).
// RUN: not %rewrite %s 2>&1 | FileCheck %s
// CHECK-DAG: reserved_name.c:[[@LINE+1]]:9: error: the sources already use the name 'SYMREAL_REAL' [SYM038]
#define SYMREAL_REAL double
// CHECK-DAG: reserved_name.c:[[@LINE+1]]:8: error: the sources already use the name 'SYMREAL_C' [SYM038]
double SYMREAL_C;
// CHECK-NOT: 'REAL'
double REAL;
