// The names in a function pragma are its parameters, or declared before it.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
// CHECK: pragma_function_names.cpp:[[@LINE+1]]:35: error: 'z' is neither a parameter of 'f' nor declared before it [SYM023]
#pragma symreal function input(x, z) output(return)
double f(double x) { return x; }
