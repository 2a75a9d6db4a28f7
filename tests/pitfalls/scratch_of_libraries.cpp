// Scratch that algorithms fill, that methods of a container change by its own iterators, and const statics of functions behind
// references and pointers count as no hidden state.
// RUN: %symreal generate %s -o %t/ --decisions=guard && %symreal verify %s %t/filled.c %t/filled_integers.c %t/erased.c %t/statics.c %t/generated.c %t/transformed.c --samples=50
// RUN: not %symreal generate %s -o %t/ --decisions=guard -- -DGENERATED 2>&1 | FileCheck %s
// CHECK: error: kernel 'generated' reads 'list[0]' (5), which is neither input nor parameter [SYM017]
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#pragma symreal function input(x) scratch(w[0:3]) output(return)
double filled(double x, double *w) {
  std::iota(w, w + 3, 1.0); // the first value is the one that was there
  std::partial_sum(w, w + 3, w);
  return std::accumulate(w, w + 3, x);
}

static int counts[3] = {5, 3, 4};
#pragma symreal function input(x) scratch(counts[0:3], w[0:3]) output(return)
double filled_integers(double x, int *w) {
  std::fill(counts, counts + 3, 4);
  std::fill(w, w + 3, 9);
  return x * counts[2] + w[1];
}

#pragma symreal function input(x) scratch(list) output(return)
double erased(double x, std::vector<int> &list) {
  list.erase(list.begin() + 1);
  list.insert(list.end(), 2);
  return x * x;
}

#pragma symreal function input(x) output(return)
double statics(double x) {
  static double const &angle = std::atan2(1.0, 3.0);
  static std::vector<double> const &list = std::vector<double>{std::cos(0.5), 1};
  static double const &first = list[0];
  static double const row[2] = {std::atan2(1.0, 2.0), 2};
  static double const *const elements = &row[0];
  static int count;
  count = 2;
  int const most = std::max<int>(x > 100 ? 1 : 3, count);
  return x * angle + first + elements[1] * *elements + most + list[1];
}

#pragma symreal function input(x) scratch(list) output(return)
double transformed(double x, std::vector<double> &list) {
  double const from[2] = {x, 2 * x};
  std::transform(from, from + 2, list.begin(), [](double z) { return -z; });
  return list[1];
}

// A function of the caller may read what it is about to fill.
#pragma symreal function input(x) scratch(list) output(return)
double generated(double x, std::vector<double> &list) {
#ifdef GENERATED
  std::generate(list.begin(), list.end(), [&] { return list[0] + x; });
#else
  std::generate(list.begin(), list.end(), [&] { return x; });
#endif
  return list[1];
}

int main() {
  double w[3] = {1, 3, 2};
  int v[3] = {1, 2, 3};
  std::vector<int> list{5, 3, 4};
  std::vector<double> numbers{5, 3};
  return filled(0.5, w) + filled_integers(0.5, v) + erased(0.5, list) + statics(0.5) + generated(0.5, numbers) + transformed(0.5, numbers) > 1e9;
}
