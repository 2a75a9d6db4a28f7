// Containers, views and members of classes that are one object, or lie in one place.
// RUN: rm -rf %t && mkdir %t && cd %t
// DEFINE: %{c} = %cxx -std=c++20 -Wall -Wextra -Wno-unknown-pragmas
// RUN: cd %t && %symreal generate %s -o ./ --wrapper -- -std=c++20
// RUN: cd %t && %symreal verify %s vectors.c views.c step.c nested.c --samples=20 --min-samples=5 -- -std=c++20 2>&1 | FileCheck %s
// CHECK: kernel vectors, mode finite
// CHECK-NEXT: the wrapper was tried as well
// CHECK: kernel views, mode finite
// CHECK-NEXT: the wrapper was tried as well
// CHECK: kernel step, mode finite
// CHECK-NEXT: the wrapper was tried as well
// CHECK: kernel nested, mode finite
// CHECK-NEXT: the wrapper was tried as well
// RUN: cd %t && %{c} %s -o original && ./original > expected
// RUN: cd %t && %cc -c vectors.c views.c step.c nested.c && %{c} vectors_wrapper.cpp vectors.o views.o step.o nested.o -o swapped && ./swapped | diff expected -
#include <cstdio>
#include <span>
#include <vector>

#pragma symreal function input(x) output(y)
static void vectors(std::vector<double> const &x, std::vector<double> &y) {
  y[0] = x[1] + 1;
  y[1] = x[0] * 2;
}
static double one_vector() {
  std::vector<double> a = {1, 2}, b = {3, 4};
  vectors(a, b);
  vectors(b, b);
  return b[0] + 10 * b[1];
}

#pragma symreal function input(x[0:2]) output(y[0:2])
static void views(std::span<double const> x, std::span<double> y) {
  y[0] = x[1] + 1;
  y[1] = x[0] * 2;
}
static double views_of_one() {
  double a[4] = {1, 2, 3, 4};
  double b[2] = {0, 0};
  views({a, 2}, {b, 2});
  views({a, 2}, {a, 2});
  views({a + 1, 2}, {a, 2});
  return a[0] + 10 * a[1] + 100 * a[2] + b[0];
}

struct Filter {
  double state[2] = {1, 2};
  void reset() { step(state, 0.5); }
#pragma symreal function input(x[0:2], gain, state) output(state)
  void step(double const *x, double gain) {
    state[0] = gain * x[1] + state[0];
    state[1] = x[0] - x[1];
  }
};
static double member() {
  Filter filter;
  double const x[2] = {4, 5};
  filter.step(x, 2);
  filter.reset();
  return filter.state[0] + 10 * filter.state[1];
}

using Rows = std::vector<std::vector<double>>;
#pragma symreal function input(x) output(y)
static void nested(Rows const &x, Rows &y) {
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 2; ++i) y[k][i] = x[i][k];
}
static double one_nested() {
  Rows a = {{1, 2}, {3, 4}}, b = a;
  nested(a, b);
  nested(b, b);
  return b[0][1] + 10 * b[1][0];
}

int main() {
  std::printf("%.17g %.17g %.17g %.17g\n", one_vector(), views_of_one(), member(), one_nested());
}
