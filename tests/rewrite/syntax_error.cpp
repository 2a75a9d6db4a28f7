// A source that does not compile is refused, with the compiler's words.
// RUN: not %rewrite %s 2>&1 | FileCheck %s --implicit-check-not=REAL
// CHECK: syntax_error.cpp:[[@LINE+1]]:{{[0-9]+}}: error: expected ';' after return statement [SYM020]
double f(double x) { return x }
// CHECK: syntax_error.cpp:[[@LINE+1]]:{{[0-9]+}}: error: use of undeclared identifier 'y' [SYM020]
double g(double x) { return y; }
// CHECK: help:
