// A pragma in a block stands where a statement can stand: neither outside of functions, nor in a declaration.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
double x;
// CHECK: pragma_position.cpp:[[@LINE+1]]:1: error: this pragma stands where no statement can stand [SYM024]
#pragma symreal input(x)
void f(double) {
  double a,
  // CHECK: pragma_position.cpp:[[@LINE+1]]:1: error: this pragma stands where no statement can stand [SYM024]
#pragma symreal generate("f.c")
  b;
}
