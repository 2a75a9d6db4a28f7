/* C that no cast can make C++. */
// RUN: not %rewrite %s 2>&1 | FileCheck %s
// CHECK: c_refused.c:[[@LINE+1]]:8: error: 'class' is a keyword of C++ [SYM037]
double class;
double twice;
// CHECK: c_refused.c:[[@LINE+1]]:8: error: 'twice' is defined a second time [SYM037]
double twice;
// CHECK: c_refused.c:[[@LINE+1]]:{{[0-9]+}}: error: C's complex double has no symbolic counterpart [SYM032]
double _Complex z;
