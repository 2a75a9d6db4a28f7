// Code that asks about types, and is answered as for double.
// RUN: %symreal generate %s -o %t.c -- -std=c++20 && %symreal verify %s %t.c --samples=50 -- -std=c++20
// RUN: grep -v "pragma symreal" %s > %t.plain.cpp
// RUN: %cxx -std=c++20 %t.plain.cpp -o %t.original && %symreal-c++ -std=c++20 %t.plain.cpp -o %t.symbolic
// RUN: %t.original > %t.expected && %t.symbolic | diff %t.expected -
#include <any>
#include <concepts>
#include <cstdio>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>

template <class T> struct is_real : std::false_type {};
template <> struct is_real<float> : std::true_type {};
template <> struct is_real<double> : std::true_type {};
template <class T> struct kind { static constexpr int value = 1; };
template <class T> struct kind<T *> { static constexpr int value = 2; };
template <class T, bool = std::is_floating_point<T>::value> struct half { static T of(T x) { return x; } };
template <class T> struct half<T, true> { static T of(T x) { return x / 2; } };
template <class T> std::enable_if_t<std::is_class<T>::value, double> by_class(T) { return 1; }
template <class T> std::enable_if_t<!std::is_class<T>::value, double> by_class(T) { return 2; }
template <class T> auto member(T x, int) -> decltype(x.size(), 1.0) { return 1; }
template <class T> double member(T, long) { return 2; }
template <class T> double rank(T) { return 1; }
static double rank(double) { return 2; }
template <class T> std::conditional_t<std::is_arithmetic_v<T>, T, std::string> chosen(T x) { return x; }

template <class T> double traits(T x) {
  double sum = 0, bit = 1;
  for (bool const one :
       {std::is_class_v<T>, std::is_fundamental_v<T>, std::is_arithmetic_v<T>, std::is_scalar_v<T>, std::is_object_v<T>,
        std::is_compound_v<T>, std::is_floating_point_v<T>, std::is_signed_v<T>, std::is_unsigned_v<T>,
        std::is_convertible_v<T, int>, std::is_convertible_v<int, T>, std::is_same_v<T, double>, std::is_trivial_v<T>,
        std::is_trivially_copyable_v<T>, std::is_standard_layout_v<T>, std::is_empty_v<T>, std::is_final_v<T>,
        std::is_polymorphic_v<T>, std::is_aggregate_v<T>, std::is_union_v<T>,
        std::is_constructible_v<T, int>, std::is_default_constructible_v<T>, std::is_nothrow_copy_constructible_v<T>,
        std::floating_point<T>, std::integral<T>, std::totally_ordered<T>, std::regular<T>, is_real<T>::value,
        std::numeric_limits<T>::is_iec559, std::numeric_limits<T>::is_specialized, std::is_same_v<decltype(x + 1), T>,
        std::is_same_v<std::common_type_t<T, int>, T>, std::is_same_v<std::decay_t<T const &>, T>}) {
    sum += one * bit;
    bit *= 2;
  }
  return sum + std::numeric_limits<T>::digits;
}

#pragma symreal function input(x) output(return)
double kernel(double x) {
  std::any const any = x;
  std::variant<int, double, std::string> const variant = x;
  return x * traits(x) + kind<double>::value + kind<double *>::value + half<double>::of(x) + by_class(x) + member(x, 0) +
         rank(x) + chosen(x) + std::any_cast<double>(any) + variant.index() + std::get<double>(variant) +
         (any.type() == typeid(double));
}

int main() { std::printf("%.17g\n", kernel(0.5)); }
