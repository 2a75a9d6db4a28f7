// A REAL that is cut to an integer in passing: what (int) is, too.
// RUN: %rewrite %s | FileCheck %s --check-prefix=TEXT
// RUN: %same %s
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
// RUN: %symreal generate --decisions=guard %s -o %t.g.c && %symreal verify --samples=100 --min-samples=10 %s %t.g.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: return {{ *}}1 {{ *}}0 {{ *}}0
#include <cstdio>

struct Record {
  float least = 0;
  int number = 1;
};

#pragma symreal function input(x) range(1, 3) output(return)
double cut(double x) {
  Record record;
  // CHECK: narrowing.cpp:[[@LINE+2]]:20: error: the program decides on a symbolic value: the conversion of 1 + x (met 1 time) [SYM016]
  // TEXT: record.number += x;
  record.number += x;
  return record.number + x;
}

int main() {
  Record outside;
  outside.least -= cut(1.5);
  std::printf("%g\n", outside.least);
}
