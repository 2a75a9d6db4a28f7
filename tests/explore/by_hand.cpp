// A program that somebody runs with this policy sees one path only, which is no exploration.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal-c++ -w %s -o %t/a.out
// RUN: not env SYMREAL_REQUEST=decisions=explore %t/a.out 2>&1 | FileCheck %s
// CHECK: error: one run of a program explores nothing: each decision is an error [SYM193]
// CHECK: symreal: a decision on x > 0; symreal generate tells where
// RUN: not ls %t/by_hand.c
#include <cstdio>

int main() {
  double x = 1, y = 0;
#pragma symreal input(x)
  if (x > 0) y = x;
#pragma symreal output(y) generate("by_hand.c")
  std::printf("%g\n", y);
}
