// The program cannot be started in a directory that is not there.
// RUN: not %symreal generate %s --cwd=%t.none -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
int main() {
  double x = 0.5, y;
#pragma symreal input(x)
  y = 2 * x;
#pragma symreal output(y) generate("y.c")
}

// CHECK: error: {{.*}} [SYM015]
// CHECK: help:
