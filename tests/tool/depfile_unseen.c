// Where the system does not tell which files the program opens, as within a program that is watched itself, a warning says so.
// RUN: rm -rf %t && mkdir %t
// RUN: env INNER="%tool generate %s -o %t/inner.c --depfile %t/inner.d -- -DINNER" %tool generate %s -o %t/outer.c 2>&1 | FileCheck %s
// CHECK: inner.d: warning: this system does not tell which files the program opened; the rule lacks them [SYM197]
#include <stdlib.h>
#pragma symreal function input(x) output(return)
double kernel(double x) { return x * 2; }
int main(void) {
#ifndef INNER
  if (system(getenv("INNER")) != 0) return 1;
#endif
  return kernel(1) > 100;
}
