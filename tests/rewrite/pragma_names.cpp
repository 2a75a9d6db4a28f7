// The names in a pragma in a block are those of its place.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
void f(double x) {
  // CHECK: pragma_names.cpp:[[@LINE+1]]:26: error: use of undeclared identifier 'yy' [SYM023]
#pragma symreal input(x, yy) generate("f.c")
  double yy = x;
}
