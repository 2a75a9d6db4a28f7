// Two pointers that a function takes by reference are no range of what lies between them.
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c && FileCheck %s --input-file=%t.c
// RUN: %same %s
// CHECK: input[3] + input[1]*input[2]
#include <algorithm>
#include <cstdio>
#include <numeric>
#include <utility>

#pragma symreal function input(x[0:4]) output(y[0:2])
void kernel(double *x, double *y) {
  double *p[2] = {x, x + 1};
  std::swap(p[0], p[1]);
  struct {
    double *a, *b;
  } s = {x + 2, x + 3};
  std::swap(s.a, s.b);
  y[0] = *p[0] * *s.b + *s.a;
  double const *const first = std::min(p[0], p[1]);
  y[1] = *first + std::accumulate(x, x + 4, 0.0);
}
int main() {
  double x[] = {0.75, 1.5, 2.25, 0.5}, y[2];
  kernel(x, y);
  std::printf("%g %g\n", y[0], y[1]);
}
