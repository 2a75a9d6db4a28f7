// Sums that begin with a literal: 0.0 sums numbers; 0 cuts each sum to an integer, in the original as well, and is refused.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
// RUN: not %symreal generate %s -o %t_cut.c -- -DCUT 2>&1 | FileCheck %s
// RUN: not ls %t_cut.c
#include <cstdio>
#include <numeric>
#include <vector>

#ifdef CUT
#define ZERO 0
#else
#define ZERO 0.0
#endif

#pragma symreal function input(x[0:3]) output(return)
double sum(std::vector<double> &x) {
  // CHECK: accumulate.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of 0 + x[0] {{.*}} [SYM016]
  return x[0] + std::accumulate(x.begin(), x.end(), ZERO);
}

int main() {
  std::vector<double> x = {0.5, 0.25, 2.0};
  std::printf("%g\n", sum(x));
}
