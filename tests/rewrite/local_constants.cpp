// Local constant objects of doubles, handed to functions that the compiler evaluates: in a template's argument, in the
// initialiser of a constant, and in an ordinary expression.
// RUN: %symreal generate %s -o %t.c -- -std=c++20 && FileCheck %s < %t.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c -- -std=c++20 2>&1 | FileCheck %s --check-prefix=VERIFY
// CHECK: input[0]
// VERIFY: value_return {{ *}}1 {{ *}}0 {{ *}}0
#include <array>
#include <utility>

struct gains {
  double a, b;
};
using Two = std::array<double, 2>;

template <class G> constexpr double total(G const &g) { return g.a + g.b; }
template <class A> constexpr double summed(A const &a) {
  double s = 0;
  for (auto v : a) s += v;
  return s;
}
template <class A> constexpr int count(A const &a) {
  int s = 0;
  for (auto v : a) s += v > 1;
  return s;
}
template <class P> constexpr double of_pair(P const &p) { return p.first * p.second; }
constexpr double dot(Two const &a, Two b) { return a[0] * b[0] + a[1] * b[1]; }
constexpr int first(double const *v) { return static_cast<int>(*v); }
constexpr double doubled(double v) {
  constexpr Two inner{2, 0.5};
  return v * dot(inner, inner);
}
template <int n> double times(double x) { return n * x; }
template <gains g> double by(double x) { return x * g.a + g.b; }
template <double d> double by_number(double x) { return x * d; }
template <Two a> double by_array(double x) { return x * a[0] + a[1]; }

#pragma symreal function input(x) range(-4, 4) output(return)
double k(double x) {
  constexpr gains g{1.5, 2.5};
  constexpr double d = 1.25, raw[3] = {1, 2, 3};
  constexpr Two list{1.0, 2.0};
  constexpr std::pair<double, double> pair{1.0, 3.0};
  constexpr double sum = summed(list) + dot(list, list) + of_pair(pair);
  static_assert(total(g) == 4.0 && summed(raw) == 6.0 && dot(list, list) == 5 && first(raw + 1) == 2);
  std::array<double, count(list)> one{x};
  double const evaluated = times<count(list)>(x) + times<count(raw)>(x) + times<static_cast<int>(total(g))>(x) +
                           times<static_cast<int>(dot(list, list))>(x) + times<first(raw + 2)>(x);
  double const valued = by<g>(x) + by<gains{1.0, 2.0}>(x) + by_number<d>(x) + by_array<list>(x);
  double const run = summed(raw) + summed(list) + count(raw) * x + of_pair(pair) + dot(list, {x, 1}) + doubled(x);
  return evaluated + valued + run + sum + one[0];
}

int main() { return k(0.3) > 100; }
