// A wrapper compares the extents within containers, not the count of their numbers alone, the text of a view, and whether
// two arguments are one object: here the original's body computes a call that is another one.
// RUN: rm -rf %t && mkdir %t && cd %t
// DEFINE: %{c} = %cxx -std=c++17 -Wno-unknown-pragmas
// RUN: cd %t && %symreal generate %s -o ./ --wrapper -- -std=c++17
// RUN: cd %t && %symreal verify %s nested.c --samples=50 -- -std=c++17 2>&1 | FileCheck %s
// CHECK: the wrapper was tried as well
// RUN: cd %t && %{c} %s -o original && ./original > expected
// RUN: cd %t && %cc -c nested.c extent.c view.c same.c && %{c} nested_wrapper.cpp nested.o extent.o view.o same.o -o swapped && ./swapped | diff expected -
#include <cstdio>
#include <string_view>
#include <vector>

using Rows = std::vector<std::vector<double>>;
#pragma symreal function input(x) output(return)
static double nested(Rows const &x) {
  double sum = 0;
  for (std::vector<double> const &row : x) {
    for (double const one : row) sum = sum * 2 + one;
    sum += static_cast<double>(row.size());
  }
  return sum;
}

using List = std::vector<double>;
#pragma symreal function input(x, weights[0:2]) output(return)
static double extent(double x, List const &list, List const &weights) {
  for (double const one : weights) x = 2 * x + one;
  return x * static_cast<double>(list.size());
}

#pragma symreal function input(x) output(return)
static double view(double x, std::string_view name) { return x * static_cast<double>(name.size()); }

struct Pair {
  double first, second;
};
#pragma symreal function input(a, b) output(return)
static double same(Pair const &a, Pair const &b) { return &a == &b ? 7 : a.first * b.second; }
static Pair const one{1, 2}, two{3, 4};

int main() {
  double const rows = nested({{1, 2}, {3}}), lists = extent(2, {1, 2}, {3, 4}), views = view(2, "sum"), pairs = same(one, two);
  std::printf("%.17g %.17g\n", rows, nested({{1}, {2, 3}}));
  std::printf("%.17g %.17g\n", lists, extent(2, {1, 2, 3}, {3, 4}) + 100 * extent(2, {1, 2}, {3, 4, 5}));
  std::printf("%.17g %.17g\n", views, view(2, "product"));
  std::printf("%.17g %.17g\n", pairs, same(one, one));
}
