// A conversion to an integer has as many outcomes as there are integers: no paths, but the error that it is by default, also on
// a path that the values of this run do not take.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: not %symreal generate %s -o %t/f.c --decisions=explore 2>&1 | FileCheck %s
// RUN: not ls %t/f.c
#include <cstdio>

#pragma symreal function input(x) output(return)
double f(double x) {
  double sum = 0;
  if (x < 1) return x;
  // CHECK: conversion.cpp:[[@LINE+1]]:23: error: the program decides on a symbolic value: the conversion of x to int {{.*}}[SYM016]
  for (int i = 0; i < (int)x; ++i) sum += x;
  return sum;
}

int main() {
  std::printf("%g\n", f(0.5));
}
