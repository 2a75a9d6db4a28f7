// The program comes to the output by a way around the input.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>

int main(int argc, char **) {
  double x = 0.5, y = 0.0;
  if (argc > 1) {
#pragma symreal input(x)
    y = std::sin(x);
  }
#pragma symreal output(y) generate("y.c")
}

// CHECK: output_first.cpp:13:24: error: {{.*}} [SYM057]
// CHECK: help:
