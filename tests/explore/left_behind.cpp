// What a path leaves in memory beside the outputs is an error as in any kernel, on each path: an integer that only another
// path than this run's changes is found as well.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: not %symreal generate %s -o %t/f.c --decisions=explore 2>&1 | FileCheck %s
// RUN: not ls %t/f.c
#include <cstdio>

// CHECK: left_behind.cpp:[[@LINE+1]]:12: error: the kernel writes 'count', which is not an output [SYM053]
static int count;
#pragma symreal function input(x) output(return)
double f(double x) {
  if (x > 0) return x;
  if (x < -1) {
    ++count;
    return -x;
  }
  return 0.5;
}

int main() {
  std::printf("%g %d\n", f(1), count);
}
