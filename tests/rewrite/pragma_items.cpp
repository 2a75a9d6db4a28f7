// What a pragma names is an object of doubles whose extent is known.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
// CHECK-DAG: pragma_items.cpp:[[@LINE+1]]:32: error: 'x' is a pointer and needs an extent: '*x' for one object, or 'x[0:n]' [SYM026]
#pragma symreal function input(x) output(return)
double pointer(double *x) { return x[0]; }
// CHECK-DAG: pragma_items.cpp:[[@LINE+1]]:32: error: 'n' holds no double: it is int [SYM026]
#pragma symreal function input(n) output(return)
double integer(int n) { return n; }
double constant() {
  double const x = 1.0;
  // CHECK-DAG: pragma_items.cpp:[[@LINE+1]]:23: error: 'x' is const: the compiler may have used its value already [SYM026]
#pragma symreal input(x)
#pragma symreal output(x) generate("k.c")
  return x;
}
// CHECK-DAG: pragma_items.cpp:[[@LINE+1]]:42: error: 'nothing' returns nothing [SYM026]
#pragma symreal function input(x) output(return)
void nothing(double x) {}
