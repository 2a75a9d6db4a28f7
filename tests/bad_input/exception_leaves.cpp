// An exception that leaves the kernel is its only result: what it wrote until then is no output.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not test -e %t.c
// CHECK: exception_leaves.cpp:[[#@LINE+3]]:1: error: kernel 'step' ends without an output [SYM052]
#include <cstdio>

#pragma symreal function input(x) output(y)
void step(double x, double &y) {
  y = x * 2;
  if (sizeof(int) == 4) throw 3;
}

int main() {
  double y = 0;
  try {
    step(0.5, y);
  } catch (int) {
    std::printf("%g\n", y);
  }
}
