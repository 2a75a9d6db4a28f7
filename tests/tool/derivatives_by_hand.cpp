// differentiate(...) in a symbolic main that is written by hand.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/y.c && FileCheck %s --input-file=%t/y.h
// RUN: %symreal verify %s %t/y.c --samples=200
// CHECK: double gradient_y[1];
#include <symreal/symbolic_main.h>

int main() {
  REAL q = create_runtime_const("q", 0.5);
  output("y", q * q * 10.0);
  differentiate("gradient(y)");
  generate_code("y.c");
}
