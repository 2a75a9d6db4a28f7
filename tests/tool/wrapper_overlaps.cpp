// Containers, matrices, views and members of classes that are one object, or lie in one place.
// RUN: rm -rf %t && mkdir %t && cd %t
// DEFINE: %{flags} = -std=c++20
// DEFINE: %{kernels} = vectors views kern nested
// DEFINE: %{c} = %cxx %{flags} -Wall -Wextra -Wno-unknown-pragmas
// DEFINE: %{try} = rm -rf k && %symreal generate %s -o k/ --wrapper -- %{flags} && %{c} %s -o original && ./original > expected && sh -ec 'for one in %{kernels}; do %cc -c k/$one.c -o one.o; %{c} k/${one}_wrapper.cpp one.o -o swapped; ./swapped | diff - expected; done' && %symreal verify %s k/*.c --samples=20 --min-samples=5 -- %{flags} 2>&1 | FileCheck %s
// RUN: cd %t && %{try} --check-prefix=FOUR
// FOUR-COUNT-4: the wrapper was tried as well
// REDEFINE: %{flags} = -std=c++20 -I/usr/include/eigen3 -DMATRICES
// REDEFINE: %{kernels} = matrices
// RUN: cd %t && %{try}
// CHECK: the wrapper was tried as well
#include <cstdio>
#include <vector>

#ifdef MATRICES
#include <Eigen/Core>
#pragma symreal function input(m, x) output(m)
static void matrices(Eigen::Ref<Eigen::MatrixXd> m, Eigen::VectorXd const &x) {
  m(0, 0) = x[1];
  m(0, 1) = x[0] + x[1] + m(1, 0);
}
static double calls() {
  Eigen::MatrixXd m(2, 2);
  m << 1, 2, 3, 4;
  Eigen::VectorXd x(2);
  x << 5, 6;
  matrices(m, x);
  matrices(m.block(0, 0, 2, 2), x);
  return m.sum();
}

#else
#include <span>
#pragma symreal function input(x) output(y)
static void vectors(std::vector<double> const &x, std::vector<double> &y) {
  y[0] = x[1] + 1;
  y[1] = x[0] * 2;
}
static double calls_vectors() {
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
static double calls_views() {
  double a[4] = {1, 2, 3, 4};
  double b[2] = {0, 0};
  views({a, 2}, {b, 2});
  views({a, 2}, {a, 2});
  views({a + 1, 2}, {a, 2});
  return a[0] + 10 * a[1] + 100 * a[2] + b[0];
}

struct Filter {
  double state[2] = {1, 2};
  void reset() { kern(state, 0.5); }
#pragma symreal function input(x[0:2], gain, state) output(state)
  void kern(double const *x, double gain) {
    state[0] = gain * x[1] + state[0];
    state[1] = x[0] - x[1];
  }
};
static double calls_member() {
  Filter filter;
  double const x[2] = {4, 5};
  filter.kern(x, 2);
  filter.reset();
  return filter.state[0] + 10 * filter.state[1];
}

using Rows = std::vector<std::vector<double>>;
#pragma symreal function input(x) output(y)
static void nested(Rows const &x, Rows &y) {
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 2; ++i) y[k][i] = x[i][k];
}
static double calls_nested() {
  Rows a = {{1, 2}, {3, 4}}, b = a;
  nested(a, b);
  nested(b, b);
  return b[0][1] + 10 * b[1][0];
}

static double calls() {
  std::printf("%.17g %.17g %.17g\n", calls_vectors(), calls_views(), calls_member());
  return calls_nested();
}
#endif

int main() { std::printf("%.17g\n", calls()); }
