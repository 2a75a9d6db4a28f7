// One generated function stands for all paths, so each has the same outputs.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: not %symreal generate %s -o %t/f.c --decisions=explore 2>&1 | FileCheck %s
// RUN: not ls %t/f.c
// CHECK: interface.cpp:[[@LINE+4]]:{{[0-9]+}}: error: output 'kept' is not the same on every path through kernel 'f' [SYM194]
#include <cstdio>
#include <vector>

#pragma symreal function input(x[0:3]) output(kept)
void f(double const *x, std::vector<double> &kept) {
  kept.clear();
  for (int i = 0; i < 3; ++i)
    if (x[i] > 0) kept.push_back(x[i]);
}

int main() {
  double x[3] = {1, -2, 3};
  std::vector<double> kept;
  f(x, kept);
  std::printf("%g\n", kept[0]);
}
