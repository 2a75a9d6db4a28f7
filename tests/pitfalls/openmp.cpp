// The symbolic program is read and compiled without OpenMP: <omp.h> is found all the same, and _OPENMP is defined in
// neither. Its functions answer as they do outside of a parallel region.
// RUN: %symreal generate %s -o %t.c -- -fopenmp && %symreal verify %s %t.c --samples=100 -- -fopenmp
// RUN: FileCheck %s --input-file=%t.c
// RUN: %symreal verify --numeric %s -- -fopenmp | FileCheck %s --check-prefix=NUMERIC
// RUN: %symreal-c++ -fopenmp %s -o %t.program && %t.program | FileCheck %s --check-prefix=PROGRAM
// NUMERIC: 1 of 1 translation units have identical object code
// PROGRAM: 1 3.5
#include <cmath>
#include <cstdio>
#include <omp.h>

// CHECK-NOT: sin
// CHECK: output[0] =
#pragma symreal function input(x[0:2]) output(return)
double sum(double const *x) {
  double total = omp_get_max_threads() > 0 ? 0.5 : std::sin(x[0]);
#ifdef _OPENMP
#pragma omp parallel for reduction(+ : total)
  for (int i = 0; i < 2; i++) total += x[i];
#else
  for (int i = 0; i < 2; i++) total += x[i];
#endif
  return total;
}

int main() {
  double const x[2] = {1.0, 2.0};
  std::printf("%d %g\n", omp_get_num_threads(), sum(x));
}
