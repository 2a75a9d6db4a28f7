// A constant object of doubles stays so, and whoever takes one whole takes an object of REALs.
// RUN: %same %s -- -std=c++20
// RUN: %rewrite %s -- -std=c++20 | FileCheck %s
// RUN: %symreal generate %s -o %t.c -- -std=c++20 && %symreal verify %s %t.c --samples=100 -- -std=c++20
#include <array>
#include <cstdio>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

// CHECK: static constexpr std::array<double, 2> pair = {1.5, 2.5};
static constexpr std::array<double, 2> pair = {1.5, 2.5};
inline constexpr std::array<std::array<double, 2>, 2> rows = {{{3.5, 2.5}, {1, 2}}};
static constexpr double plain[3] = {1, 2, 3};
constexpr double const *behind = plain + 1;
constexpr std::optional<double> maybe = 3.0;
constexpr std::pair<double, int> both = {4, 5};
constexpr double single = plain[1] * 2;
static_assert(pair[0] == 1.5 && sizeof(std::array<int, static_cast<int>(pair[1])>) == 8);

using Two = std::array<double, 2>;
struct Law {
  static constexpr std::array<double, 2> own = {7, 8};
  // CHECK: return of(REAL_DEDUCED(own), x);
  double at(double x) const { return of(own, x); }
  static double of(Two const &v, double x) { return v[0] + v[1] * x; }
};
template <class T> struct Generic {
  static constexpr std::array<T, 2> own = {9, 10};
  std::array<T, 2> mine;
  // CHECK: Generic() : mine(REAL_DEDUCED(pair)) {}
  Generic() : mine(pair) {}
  T at(T x) const { return Law::of(own, x) + mine[1] * x; }
};
struct Model {
  Two c;
};
struct Kept {
  double const *at;
  Two c;
  // CHECK: Kept() : at(REAL_DEDUCED(plain)), c(REAL_DEDUCED(pair)) {}
  Kept() : at(plain), c(pair) {}
};

static double copied(Two v, double x) { return v[1] * x; }
static double pointed(Two const *v, double const *p, double x) { return (*v)[0] * p[1] * x; }
static double array(double const (&v)[3], double x) { return v[2] * x; }
static double number(double const &v, double x) { return v * x; }
static double span(std::span<double const> v, double x) { return v[0] + v[1] * x; }
static double library(std::optional<double> const &o, std::pair<double, int> const &p, double x) {
  return *o * x + p.first * p.second;
}
template <class T> T dot(std::array<T, 2> const &v, T x) { return v[0] + v[1] * x; }
template <class T> T pointed_to(T const *v, T x) { return v[0] + v[1] * x; }
// CHECK: return dot(REAL_DEDUCED(pair), x) + {{.*}}pointed_to(REAL_DEDUCED(plain), x)
template <class T> T depends(T x) { return dot(pair, x) + pointed_to(plain, x); }
template <class C> double sum(C const &c, double x) {
  double y = 0;
  for (auto const &e : c) y += e * x;
  return y;
}
// CHECK: const &handed() { return REAL_DEDUCED(pair); }
static Two const &handed() { return pair; }
static Two chosen(bool is_first, Two const &other) { return is_first ? pair : other; }

// A constexpr function is evaluated by the compiler.
constexpr double first(auto const &v) { return v[0]; }
// CHECK: constexpr REAL front() { return first(pair); }
constexpr double front() { return first(pair); }
static_assert(front() > 1);

#pragma symreal function input(x) output(return)
double kernel(double x) {
  static constexpr std::array<double, 2> local = {0.5, 0.25};
  constexpr std::array<double, 2> automatic = {0.75, 0.125};
  auto const lambda = [](auto const &v, double f) { return v[0] * f; };
  std::function<double(Two const &)> const erased = [x](Two const &v) { return v[0] * x; };
  // CHECK: REAL y = Law::of(REAL_DEDUCED(local), x) + Law::of(REAL_DEDUCED(automatic), x) + Law::of(REAL_DEDUCED(rows[1]), x);
  double y = Law::of(local, x) + Law::of(automatic, x) + Law::of(rows[1], x);
  y += Law{}.at(x) + Generic<double>{}.at(x) + copied(pair, x) + pointed(&pair, plain, x) + pointed(&rows[0], behind, x);
  y += array(plain, x) + number(single, x) + number(plain[1], x) + span(plain, x) + span(pair, x);
  y += library(maybe, both, x) + dot(pair, x) + sum(pair, x) + sum(plain, x) + lambda(pair, x) + erased(local);
  y += handed()[0] * x + chosen(true, pair)[1] + chosen(false, local)[1] * x;
  Two changed = {x, x};
  changed = pair;
  changed[1] = x;
  // CHECK: Model const model = {REAL_DEDUCED(pair)}, other{REAL_DEDUCED(local)};
  Model const model = {pair}, other{local};
  auto copy = pair;
  copy[0] *= x;
  auto const &reference = rows;
  std::vector<double> const numbers(pair.begin(), pair.end());
  y += changed[0] * changed[1] + model.c[0] * x + other.c[1] + copy[0] + copied(reference[0], x) + numbers[1] * x;
  for (double const *at = plain; at != plain + 3; ++at) y += *at * x;
  constexpr double known = front();
  y += known * x + front();
  Kept const kept;
  y += kept.at[1] * kept.c[0] * x + depends(x);
  for (auto const &row : rows) y += copied(row, x);
  for (auto e : plain) y = std::max(e, 1.0) + y;
  // Elements and what a library computes of them are doubles as before.
  // CHECK: y += pair[0] * x + std::accumulate(REAL_FIRST({{.*}}, plain), REAL_LAST({{.*}}, plain + 3), REAL_C(0.0)) + {{.*}}std::get<0>(both)
  return y += pair[0] * x + std::accumulate(plain, plain + 3, 0.0) + std::get<0>(both);
}

int main() { std::printf("%g\n", kernel(0.5)); }
