// Code that looks at the type of a comparison, or asks what a number converts to, finds what it finds with double.
// RUN: %same %s -- -std=c++20
// RUN: %rewrite %s -- -std=c++20 | FileCheck %s
// RUN: grep -v "pragma symreal" %s > %t.plain.cpp
// RUN: %cxx -std=c++20 %t.plain.cpp -o %t.orig && %symreal-c++ -std=c++20 %t.plain.cpp -o %t.exe
// RUN: %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: %symreal generate %s -o %t.c -- -std=c++20 && %symreal verify %s %t.c --min-samples=20 --samples=100 -- -std=c++20
#include <compare>
#include <complex>
#include <concepts>
#include <cstdio>
#include <type_traits>

template <class T> double kind(T const &) { return std::is_same_v<T, bool> ? 1.0 : 2.0; }
// CHECK: decltype(REAL_TRUTH(a < b))
template <class T> double of_operands(T a, T b) { return std::is_same_v<decltype(a < b), bool> ? 1.0 : 2.0; }
// CHECK: sizeof(REAL_TRUTH(a == b))
template <class T> double size(T a, T b) { return sizeof(a == b) + sizeof(a + b); }
// CHECK: { REAL_TRUTH(a < b) } -> std::same_as<bool>;
template <class T> concept Ordered = requires(T a, T b) { { a < b } -> std::same_as<bool>; };
template <class T> double of_concept(T) { return Ordered<T> ? 1.0 : 2.0; }
template <class T> double traits(T) {
  return std::three_way_comparable<T> + 2 * std::is_convertible_v<T, bool> + 4 * std::is_convertible_v<T const &, int> +
         8 * std::is_scalar_v<T> + 16 * std::is_class_v<T> + 32 * std::convertible_to<T, float>;
}
template <class T> double auto_variable(T a) {
  auto const small = a < 3;
  return sizeof(small) + kind(small) + sizeof small;
}
static double chosen(bool) { return 1.0; }
static double chosen(int) { return 2.0; }
static double chosen(double) { return 3.0; }
struct Point {
  double x, y;
  auto operator<=>(Point const &) const = default;
};

#pragma symreal function input(x[0:2]) output(y[0:13]) decisions(guard)
void compute(double const *x, double *y) {
  // CHECK: * sizeof(REAL_TRUTH(
  y[0] = x[0] * sizeof(x[0] > 1);
  y[1] = x[0] * (std::is_same_v<decltype(x[0] > 1), bool> ? 1 : 2);
  y[2] = x[0] * kind(x[0] > 1);
  y[3] = x[0] * of_operands(x[0], x[1]);
  y[4] = x[0] * size(x[0], x[1]);
  y[5] = x[0] * of_concept(x[0]);
  y[6] = x[0] * traits(x[0]);
  auto const large = x[0] > 1;
  y[7] = x[0] * (sizeof(large) + kind(large) + sizeof(!large));
  y[8] = x[0] * auto_variable(x[0]);
  y[9] = x[0] * chosen(x[0] > 1);
  y[10] = x[0] * (Point{x[0], 1.0} < Point{x[1], 2.0} ? 1.0 : 2.0);
  y[11] = x[0] * ((x[0] <=> x[1]) > 0 ? 1.0 : 2.0);
  // The absolute value of a complex number is one of REALs.
  // CHECK: sizeof(REAL_TRUTH(std::abs(z) > 1)){{.*}}sizeof(std::abs(one) > 1)
  std::complex<double> const z(x[0], 1.0);
  static constexpr std::complex<double> one(1.0, 0.0);
  y[12] = x[0] * sizeof(std::abs(z) > 1) + sizeof(std::abs(one) > 1);
}

int main() {
  double x[2] = {5.3, 2.0}, y[13];
  compute(x, y);
  for (double each : y) std::printf("%.17g\n", each);
}
