// Where a path goes round for ever it is left to a guard, after the time that a run may take.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/f.c --decisions=explore --timeout=2 2>&1 | FileCheck %s
// CHECK: warning: of kernel 'f' 2 paths are recorded, and 1 guard refuses what remains [SYM192]
// CHECK: note: on 1 path the program did not come to the kernel's end in time
// CHECK: 0 cut off by the depth, 0 ended by the program, 1 not in time
// CHECK: guard 1 endless.cpp:[[#@LINE+7]]:{{[0-9]+}}: x < 0 is false
#include <cstdio>

#pragma symreal function input(x) output(return)
double f(double x) {
  int n = 0;
  if (x > 1) return x;
  while (x < 0) ++n;
  return n + 2 * x;
}

int main() {
  std::printf("%g\n", f(0.5));
}
