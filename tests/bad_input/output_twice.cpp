// An output met again before generate: which of the values is meant?
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>

int main() {
  double x = 0.5, y;
#pragma symreal input(x)
  for (int i = 0; i < 3; i++) {
    y = std::sin(i * x);
#pragma symreal output(y)
  }
#pragma symreal generate("y.c")
}

// CHECK: output_twice.cpp:12:24: error: {{.*}} [SYM058]
// CHECK: help:
