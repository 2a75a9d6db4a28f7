// A number that a library computes something else from, or keeps: what comes of it would be a constant of the program,
// so it is a decision where the number is symbolic. What is only shown is none.
// RUN: rm -rf %t && mkdir -p %t/source %t/library && cp %S/Inputs/library.h %t/library && cp %s %t/source/k.cpp
// RUN: cd %t/source && %symreal rewrite --diff k.cpp -- -isystem ../library | FileCheck %s --check-prefix=TEXT
// RUN: cd %t/source && %symreal verify --numeric k.cpp -- -isystem ../library
// RUN: cd %t/source && not %symreal generate k.cpp -o k.c -- -isystem ../library 2>&1 | FileCheck %s
// RUN: not ls %t/source/k.c
#include <chrono>
#include <cstdio>
#include <library.h>
#include <random>

#pragma symreal function input(x) output(return)
double f(double x) {
  // TEXT: + show(REAL_VALUE(x));
  show(x);
  // TEXT: + REAL y = x * band(REAL_TO(decltype(0.0), x));
  // CHECK: k.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of x (met 1 time)
  double y = x * band(x);
  std::mt19937 generator(1);
  // TEXT: + std::normal_distribution<double> noise(REAL_TO(decltype(0.0), y), 1.0);
  // CHECK: k.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of x * 3 (met 1 time)
  std::normal_distribution<double> noise(y, 1.0);
  // CHECK: k.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of
  std::chrono::duration<double> elapsed(2 * x);
  return y + noise(generator) + elapsed.count();
}

int main() { std::printf("%g %d\n", f(1.5), band(2.5)); }
