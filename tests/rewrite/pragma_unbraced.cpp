// A pragma takes the place of a statement, so it cannot stand between `if` and its statement.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
void f(double x) {
  if (x > 0)
    // CHECK: pragma_unbraced.cpp:[[@LINE+1]]:1: error: this pragma stands where no statement can stand [SYM024]
#pragma symreal input(x) generate("f.c")
    x = 1;
}
