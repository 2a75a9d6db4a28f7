// Code that asks whether a type is a floating-point number takes the same way with REAL as with double.
// RUN: %same %s -- -std=c++20
// RUN: %symreal generate %s -o %t.c -- -std=c++20 && %symreal verify %s %t.c --samples=100 -- -std=c++20
// RUN: FileCheck %s --input-file=%t.c
#include <concepts>
#include <cstdio>
#include <type_traits>

template <class T> std::enable_if_t<std::is_floating_point<T>::value, T> half(T x) { return x / 2; }
template <class T> std::enable_if_t<!std::is_floating_point<T>::value, T> half(T x) { return x; }
template <class T> T third(T x) {
  if constexpr (std::is_arithmetic_v<T> && !std::is_integral_v<T>) return x / 3;
  return x;
}
template <class T> requires std::floating_point<T> T quarter(T x) { return x / 4; }
template <class T, class = std::enable_if_t<!std::is_floating_point_v<T>>> T quarter(T x, int = 0) { return x; }

// CHECK: = input[0]*0.25 + (input[0]/3.0 + input[0]*0.5);
#pragma symreal function input(x) output(return)
double parts(double x) { return half(x) + third(x) + quarter(x); }

int main() { std::printf("%g\n", parts(0.5)); }
