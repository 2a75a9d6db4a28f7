// Pointers to const that are inputs keep their identity: comparisons, differences, and what lies around the section.
// RUN: %symreal generate %s -o %t.c --frozen=warn 2>&1 | FileCheck %s
// RUN: %symreal verify %s %t.c --samples=100
// RUN: %cxx %s -o %t.exe && %t.exe | FileCheck %s --check-prefix=RESULT
// RUN: %symreal generate %s -o %t.c --frozen=allow --run-on 2>&1 | FileCheck %s --check-prefix=RESULT
// RESULT: 17.5
// CHECK: warning: kernel 'weigh' reads 'base' (8), which is neither input nor parameter [SYM017]
#include <cstddef>
#include <cstdio>

static double base[4] = {1, 2, 4, 8};

#pragma symreal function input(x[0:2]) output(return)
double weigh(double const *x, double const *first) {
  double sum = x[0] * x[1] * static_cast<double>(x - first);
  if (x == base + 1) sum += x[0];
  if (x >= base && x < base + 4) sum += 0.5;
  return sum + x[2] - x[0] + x[1] / 4;
}

int main() { std::printf("%g\n", weigh(base + 1, base)); }
