// A function pragma belongs to the definition behind it.
// RUN: not %rewrite %s 2>&1 | FileCheck %s --implicit-check-not=error:
// CHECK: pragma_unattached.cpp:[[@LINE+1]]:1: error: no function definition follows this pragma [SYM025]
#pragma symreal function input(x) output(return)
double f(double x);
double f(double x) { return x; }
