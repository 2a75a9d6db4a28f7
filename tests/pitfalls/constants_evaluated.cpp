// Constant objects of doubles that the compiler hands to functions of the program while it evaluates.
// RUN: %same %s -- -std=c++20
// RUN: %rewrite %s -- -std=c++20 | FileCheck %s
// RUN: %symreal generate %s -o %t.c -- -std=c++20 && %symreal verify %s %t.c --samples=100 -- -std=c++20
#include <array>
#include <cstdio>
#include <utility>

using Three = std::array<double, 3>;
constexpr Three weights{0.25, 0.5, 0.25};
constexpr double plain[2] = {1, 2};
constexpr std::pair<double, double> range{1.5, 2.5};
constexpr std::array<std::array<double, 2>, 2> rows{{{0, 1}, {1, 0}}};
struct Gains {
  static constexpr std::array<double, 2> own{3, 4};
};

constexpr double dot(Three const &a, Three const &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
constexpr double sum(double const (&v)[2]) { return v[0] + v[1]; }
constexpr double first(double const *v) { return v[0]; }
constexpr double width(std::pair<double, double> const &r) { return r.second - r.first; }
constexpr double product(std::array<double, 2> v) { return v[0] * v[1]; }
constexpr Three scaled(Three a, double s) {
  for (double &one : a) one *= s;
  return a;
}

// CHECK: constexpr double norm = REAL_VALUE(dot(REAL_CONSTANT(weights), REAL_CONSTANT(weights)));
constexpr double norm = dot(weights, weights);
static_assert(norm == 0.375 && sum(plain) == 3);
// CHECK: constexpr double inner = REAL_VALUE(first(REAL_CONSTANT(plain) + 1) + width(REAL_CONSTANT(range)));
constexpr double inner = first(plain + 1) + width(range);
// CHECK: constexpr Three twice = REAL_PLAIN_OBJECT(scaled(REAL_CONSTANT(weights), 2));
constexpr Three twice = scaled(weights, 2);
constexpr auto deduced = scaled(twice, 2);
static_assert(twice[1] == 1 && dot(deduced, weights) == 1.5);
constexpr std::array<int, static_cast<int>(product(Gains::own))> sized{};

// CHECK: constexpr REAL within(REAL x) { return dot(REAL_CONSTANT(weights), REAL_CONSTANT(twice)) * x + product(REAL_CONSTANT(rows)[1]); }
constexpr double within(double x) { return dot(weights, twice) * x + product(rows[1]); }
constexpr double of_within = within(2) + product(Gains::own);
template <class T> constexpr T generic(T x) { return static_cast<T>(dot(weights, twice)) * x; }
static_assert(generic(2.0) == 1.5 && generic(2.0F) == 1.5F);

#pragma symreal function input(x) output(return)
double kernel(double x) {
  Three const v = {x, 1, x};
  double y = norm * x + inner + dot(twice, v) + dot(v, deduced) + within(x) + of_within + generic(x);
  return y + static_cast<double>(sized.size()) + product(rows[0]) * x;
}

int main() { std::printf("%g\n", kernel(0.5)); }
