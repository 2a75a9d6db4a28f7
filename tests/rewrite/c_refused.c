/* C that no cast can make C++. */
// RUN: not %rewrite %s 2>&1 | FileCheck %s
// CHECK: c_refused.c:[[@LINE+1]]:8: error: 'wchar_t' is a keyword of C++ [SYM037]
double wchar_t;
double half(), (*way)();
// CHECK: c_refused.c:[[@LINE+2]]:23: error: a function that is declared without parameters is called with arguments [SYM037]
// CHECK: c_refused.c:[[@LINE+1]]:37: error: a function that is declared without parameters is called with arguments [SYM037]
double one() { return way(half()) + half(2); }
// CHECK: c_refused.c:[[@LINE+1]]:8: error: 'twice' is defined more than once, and here not by a line of its own [SYM037]
double twice, other;
double twice = 2;
// CHECK: c_refused.c:[[@LINE+1]]:{{[0-9]+}}: error: C's complex double has no symbolic counterpart [SYM032]
double _Complex z;
