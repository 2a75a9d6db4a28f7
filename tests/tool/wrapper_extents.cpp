// A wrapper compares the extents within containers, not the count of their numbers alone, the text of a view, and whether
// two arguments are one object: here the original's body computes a call that is another one.
// RUN: rm -rf %t && mkdir %t && cd %t
// DEFINE: %{kernel} =
// DEFINE: %{flags} = -std=c++17 -I/usr/include/eigen3 -D%{kernel}
// DEFINE: %{try} = cd %t && %symreal generate %s -o k.c --wrapper -- %{flags} && %cc -c k.c && %cxx %{flags} -Wno-unknown-pragmas k_wrapper.cpp k.o -o swapped && %cxx %{flags} -Wno-unknown-pragmas %s -o original && ./original > expected && ./swapped | diff - expected
// REDEFINE: %{kernel} = NESTED
// RUN: %{try}
// RUN: cd %t && %symreal verify %s k.c --samples=50 -- %{flags} 2>&1 | FileCheck %s
// CHECK: the wrapper was tried as well
// REDEFINE: %{kernel} = MATRIX
// RUN: %{try}
// REDEFINE: %{kernel} = EXTENT
// RUN: %{try}
// REDEFINE: %{kernel} = VIEW
// RUN: %{try}
// REDEFINE: %{kernel} = SAME
// RUN: %{try}
// An object that may be empty cannot be compared.
// REDEFINE: %{kernel} = OPAQUE
// RUN: cd %t && not %symreal generate %s -o o.c --wrapper -- %{flags} 2>&1 | FileCheck %s --check-prefix=OPAQUE
// OPAQUE: error: --wrapper cannot compare 'list' of 'kern', which is baked in: it is a std::map [SYM095]
#include <cstdio>
#include <map>
#include <string_view>
#include <vector>

#if defined(NESTED)
using Rows = std::vector<std::vector<double>>;
#pragma symreal function input(x) output(return)
static double kern(Rows const &x) {
  double sum = 0;
  for (std::vector<double> const &row : x) {
    for (double const one : row) sum = sum * 2 + one;
    sum += static_cast<double>(row.size());
  }
  return sum;
}
static double first() { return kern({{1, 2}, {3}}); }
static double other() { return kern({{1}, {2, 3}}); }

#elif defined(MATRIX)
#include <Eigen/Core>
#pragma symreal function input(x) output(return)
static double kern(Eigen::MatrixXd const &x) {
  double sum = 0;
  for (int i = 0; i < x.rows(); ++i) sum = sum * 2 + x(i, x.cols() - 1);
  return sum;
}
static double first() { return kern(Eigen::MatrixXd::Constant(2, 3, 1.5)); }
static double other() { return kern(Eigen::MatrixXd::Constant(3, 2, 1.5)); }

#elif defined(EXTENT)
using List = std::vector<double>;
#pragma symreal function input(x, weights[0:2]) output(return)
static double kern(double x, List const &list, List const &weights) {
  for (double const one : weights) x = 2 * x + one;
  return x * static_cast<double>(list.size());
}
static double first() { return kern(2, {1, 2}, {3, 4}); }
static double other() { return kern(2, {1, 2, 3}, {3, 4}) + 100 * kern(2, {1, 2}, {3, 4, 5}); }

#elif defined(VIEW)
#pragma symreal function input(x) output(return)
static double kern(double x, std::string_view name) { return x * static_cast<double>(name.size()); }
static double first() { return kern(2, "sum"); }
static double other() { return kern(2, "product"); }

#elif defined(SAME)
struct Pair {
  double first, second;
};
#pragma symreal function input(a, b) output(return)
static double kern(Pair const &a, Pair const &b) { return &a == &b ? 7 : a.first * b.second; }
static Pair const one{1, 2}, two{3, 4};
static double first() { return kern(one, two); }
static double other() { return kern(one, one); }

#else
#pragma symreal function input(x) output(return)
static double kern(double x, std::map<int, double> const &list) { return list.empty() ? x : 2 * x; }
static double first() { return kern(2, {}); }
static double other() { return kern(2, {{1, 2}}); }
#endif

int main() {
  double const one = first();
  std::printf("%.17g %.17g\n", one, other());
}
