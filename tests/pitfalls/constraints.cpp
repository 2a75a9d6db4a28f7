// Constraints on a template, whose text may end with a name or hold braces before the function begins.
// RUN: rm -rf %t && mkdir %t
// RUN: %same %s -- -std=c++20
// RUN: %rewrite %s -- -std=c++20 | FileCheck %s
// RUN: %symreal generate %s -o %t/ -- -std=c++20
// RUN: %symreal verify %s %t/braced.c --kernel braced --samples=100 -- -std=c++20
// RUN: %symreal verify %s %t/named.c --kernel named --samples=100 -- -std=c++20
// RUN: %symreal verify %s %t/of.c --kernel of --samples=100 -- -std=c++20
#include <concepts>
#include <cstdio>

template <class T> concept Number = std::same_as<T, double>;
template <class T> concept Sized = sizeof(T) == 8;
template <class T> struct Traits {
  static constexpr bool holds = true;
};

// CHECK: requires Number<T> REAL_ONLY(__attribute__(())) REAL twice(T x);
template <class T> requires Number<T> double twice(T x);
// CHECK: requires Number<T> REAL_ONLY(__attribute__(())) REAL twice(T x)
template <class T> requires Number<T> double twice(T x) { return x * 2; }
// CHECK: requires Traits<T>::holds REAL_ONLY(__attribute__(())) REAL const &same(T const &x)
template <class T> requires Traits<T>::holds double const &same(T const &x) { return x; }
// CHECK: requires (Sized<T>) REAL grown(T x)
template <class T> requires (Sized<T>) double grown(T x) { return x + 1; }
// CHECK: requires Number<T> REAL_ONLY(__attribute__(())) REAL half = 0.5;
template <class T> requires Number<T> double half = 0.5;

#pragma symreal function input(x) output(return)
template <class T> requires requires (T a) { a * a; } double braced(T x) { return twice(x) * same(x) + grown(x); }

#pragma symreal function input(x) output(return)
double named(Sized auto x) { return x * 3; }

template <class T> struct Scaled {
  double factor = 2;
  template <class U> requires Number<U> && Sized<T> double of(U x) const requires (sizeof(int) == 4);
};
#pragma symreal function input(x) output(return) constant(factor)
template <class T> template <class U> requires Number<U> && Sized<T>
double Scaled<T>::of(U x) const requires (sizeof(int) == 4) { return x * factor; }

int main() { std::printf("%g\n", braced(0.5) + named(0.5) + Scaled<long>{}.of(0.5) + half<double>); }
