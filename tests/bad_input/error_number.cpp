// errno, where a function of a symbolic value may have set it: what generated code does not tell.
// RUN: %same %s
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cerrno>
#include <cmath>
#include <cstdio>

static double logarithm(double x) {
  errno = 0;
  double const y = std::log(x);
  // CHECK-DAG: error_number.cpp:[[@LINE+1]]:10: error: errno is read where log(x) may have set it [SYM145]
  return errno == EDOM ? 0.0 : y;
}

#define FAILED (errno != 0)

#pragma symreal function input(x) output(return)
double root(double x) {
  errno = 0;
  double y = std::sqrt(x);
  // CHECK-DAG: error_number.cpp:[[@LINE+1]]:7: error: errno is read where sqrt(x) may have set it [SYM145]
  if (errno) y = -1;
  errno = 0;
  double const z = std::ldexp(x, 3);
  // CHECK-DAG: error_number.cpp:[[@LINE+1]]:7: error: errno is read where x * 8 may have set it [SYM145]
  if (FAILED) y = 2;
  return y + z + logarithm(x);
}

int main() { std::printf("%g\n", root(2.0)); }
