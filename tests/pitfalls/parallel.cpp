// Parallel regions run one after the other while a kernel is recorded.
// RUN: %symreal generate %s -o %t.c -- -fopenmp && %symreal verify %s %t.c --samples=100 -- -fopenmp
// RUN: FileCheck %s --input-file=%t.c
#include <cmath>
#include <cstdio>

// CHECK: sin(input[0])
// CHECK: sin(input[3])
#pragma symreal function input(x[0:4]) output(return)
double sum(double const *x) {
  double total = 0.0;
#pragma omp parallel for reduction(+ : total)
  for (int i = 0; i < 4; i++) total += std::sin(x[i]);
  return total;
}

int main() {
  double const x[4] = {0.5, 0.25, 2.0, 1.0};
  std::printf("%g\n", sum(x));
}
