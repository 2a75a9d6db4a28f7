// A symbolic main decides on an input to which it gives no value.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %cxx -std=c++20 -DMBD_SYMBOLIC -I%runtime_include %s %library -o symbolic
// RUN: not ./symbolic 2>&1 | FileCheck %s
// RUN: not ls limited.c
#include <symreal/symbolic_main.h>

int main() {
  REAL y = 2 * create_runtime_const("x");
  if (y > 1) y = 1;
  output("y", y);
  generate_code("limited.c");
}

// CHECK: error: the decision on (2 * x) > 1 depends on an input that has no value [SYM056]
// CHECK: help: give create_runtime_const a value
