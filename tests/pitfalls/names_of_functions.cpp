// A program's own functions are called, whatever the recording library calls its own: for double the language looks
// into no namespace.
// RUN: rm -rf %t && mkdir %t && cd %t && %symreal generate %s -o own.c 2> log && FileCheck %s < own.c
// RUN: cd %t && %symreal verify --samples=100 --min-samples=10 %s own.c
// RUN: %same %s
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace own {
// Not what the library's do: each is told by the number that it adds.
double max(double a, double b) { return a + b + 1; }
template <class T> T min(T a, T b) { return a + b + 2; }
template <class T> T value(T x) { return x + 3; }
template <class T> T abs(T x) { return x + 4; }
double select(bool first, double a, double b) { return (first ? a : b) + 5; }
template <class T> T read(T x, char const *, int) { return x + 6; }
template <class T> T truth(T x) { return x + 7; }
template <class T> T clamp(T x, T, T) { return x + 8; }
double kernel(double x, double y) {
  return max(x, y) + max(1 / 3.0, y) + min(x, y) + value(x) + abs(x) + select(true, x, y) + read(x, "", 0) + truth(x) +
         clamp(x, y, y) + std::max(x, y) + std::abs(x);
}
} // namespace own

double hypot3(double x) { return x; }
double sqr(double x) { return x * x; }
template <class T> T sign(T x) { return x + 9; }

#pragma symreal function input(x, y) output(return)
double kernel(double x, double y) {
  using std::max;
  return own::kernel(x, y) + max(x, 2 * y) + sign(x) + sqr(hypot3(y)) + std::sqrt(x * x) + fabs(y);
}

int main() { std::printf("%g\n", kernel(0.5, 0.25)); }
// CHECK: + 5.0 + (input[0] + 4.0 + (input[0] + 3.0 + (t1 + 2.0 +
// CHECK: 0.3333333333333333 + 1.0 + (t1 + 1.0)))));
// CHECK: (input[0] < input[1] ?
// CHECK-NEXT: input[1] : input[0]) + (input[0] + 8.0 + (input[0] + 7.0 + (input[0] + 6.0 +
// CHECK: sqrt(input[0]*input[0]) + (input[1]*input[1] + (input[0] + 9.0
