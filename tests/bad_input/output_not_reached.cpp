// The output stands in the source, but the program goes around it.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>

int main(int argc, char **) {
  double x = 0.5, y;
#pragma symreal input(x)
  y = std::sin(x);
  if (argc > 1) {
#pragma symreal output(y)
  }
#pragma symreal generate("y.c")
}

// CHECK: output_not_reached.cpp:14:{{[0-9]+}}: error: {{.*}} [SYM052]
// CHECK: help:
