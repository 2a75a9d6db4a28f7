// Containers, matrices, views and members of classes that are one object, or lie in one place.
// RUN: rm -rf %t && mkdir %t && cd %t
// DEFINE: %{kernel} =
// DEFINE: %{flags} = -std=c++20 -I/usr/include/eigen3 -D%{kernel}
// DEFINE: %{c} = %cxx %{flags} -Wall -Wextra -Wno-unknown-pragmas
// DEFINE: %{try} = cd %t && %symreal generate %s -o k.c --wrapper -- %{flags} && %cc -c k.c && %{c} -c k_wrapper.cpp && %{c} k_wrapper.o k.o -o swapped && %{c} %s -o original && ./original > expected && ./swapped | diff - expected && %symreal verify %s k.c --samples=20 --min-samples=5 -- %{flags} 2>&1 | FileCheck %s
// CHECK: the wrapper was tried as well
// REDEFINE: %{kernel} = VECTORS
// RUN: %{try}
// REDEFINE: %{kernel} = MATRICES
// RUN: %{try}
// REDEFINE: %{kernel} = VIEWS
// RUN: %{try}
// REDEFINE: %{kernel} = MEMBER
// RUN: %{try}
// REDEFINE: %{kernel} = NESTED
// RUN: %{try}
#include <cstdio>
#include <vector>

#if defined(VECTORS)
#pragma symreal function input(x) output(y)
static void kern(std::vector<double> const &x, std::vector<double> &y) {
  y[0] = x[1] + 1;
  y[1] = x[0] * 2;
}
static double calls() {
  std::vector<double> a = {1, 2}, b = {3, 4};
  kern(a, b);
  kern(b, b);
  return b[0] + 10 * b[1];
}

#elif defined(MATRICES)
#include <Eigen/Core>
#pragma symreal function input(m, x) output(m)
static void kern(Eigen::Ref<Eigen::MatrixXd> m, Eigen::VectorXd const &x) {
  m(0, 0) = x[1];
  m(0, 1) = x[0] + x[1] + m(1, 0);
}
static double calls() {
  Eigen::MatrixXd m(2, 2);
  m << 1, 2, 3, 4;
  Eigen::VectorXd x(2);
  x << 5, 6;
  kern(m, x);
  kern(m.block(0, 0, 2, 2), x);
  return m.sum();
}

#elif defined(VIEWS)
#include <span>
#pragma symreal function input(x[0:2]) output(y[0:2])
static void kern(std::span<double const> x, std::span<double> y) {
  y[0] = x[1] + 1;
  y[1] = x[0] * 2;
}
static double calls() {
  double a[4] = {1, 2, 3, 4};
  double b[2] = {0, 0};
  kern({a, 2}, {b, 2});
  kern({a, 2}, {a, 2});
  kern({a + 1, 2}, {a, 2});
  return a[0] + 10 * a[1] + 100 * a[2] + b[0];
}

#elif defined(MEMBER)
struct Filter {
  double state[2] = {1, 2};
  void reset() { kern(state, 0.5); }
#pragma symreal function input(x[0:2], gain, state) output(state)
  void kern(double const *x, double gain) {
    state[0] = gain * x[1] + state[0];
    state[1] = x[0] - x[1];
  }
};
static double calls() {
  Filter filter;
  double const x[2] = {4, 5};
  filter.kern(x, 2);
  filter.reset();
  return filter.state[0] + 10 * filter.state[1];
}

#else
using Rows = std::vector<std::vector<double>>;
#pragma symreal function input(x) output(y)
static void kern(Rows const &x, Rows &y) {
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 2; ++i) y[k][i] = x[i][k];
}
static double calls() {
  Rows a = {{1, 2}, {3, 4}}, b = a;
  kern(a, b);
  kern(b, b);
  return b[0][1] + 10 * b[1][0];
}
#endif

int main() { std::printf("%.17g\n", calls()); }
