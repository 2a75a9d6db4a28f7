// A program that does not come to the same decisions after the same outcomes cannot be explored.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: not %symreal generate %s -o %t/f.c --decisions=explore --explore=joins=off --run-args=%t/state --cwd=%t 2>&1 | FileCheck %s
// RUN: not ls %t/f.c
// CHECK: not_repeated.cpp:[[@LINE+4]]:{{[0-9]+}}: error: with the same outcomes of its decisions the kernel decides on other values [SYM190]
#include <cstdio>

static double limit;
#pragma symreal function input(x) constant(limit) output(return)
double f(double x) {
  if (x > limit) return x;
  return limit;
}

// The state of a run is kept in a file for the next.
int main(int, char **argv) {
  if (std::FILE *file = std::fopen(argv[1], "a")) {
    limit = static_cast<double>(std::ftell(file));
    std::fputs("one more run\n", file);
    std::fclose(file);
  }
  std::printf("%g\n", f(3));
}
