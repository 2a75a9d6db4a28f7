// Templates that are specialised or instantiated for double are so for REAL.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
// RUN: FileCheck %s --input-file=%t.c
#include <cstdio>

template <class T> struct Weight {
  static T of(T x) { return x; }
};
template <> struct Weight<double> {
  static double of(double x) { return 3.0 * x; }
};
template <class T> T scaled(T x) { return x; }
template <> double scaled(double x) { return 5.0 * x; }
template <class T, class U> struct Pair {
  static int const kind = 0;
};
template <class U> struct Pair<double, U> {
  static int const kind = 7;
};
template <class T> T plus(T x) { return x + Pair<T, int>::kind; }
template double plus<double>(double);

// CHECK-DAG: input[0]*3.0
// CHECK-DAG: input[0]*5.0
// CHECK-DAG: input[0] + 7.0
#pragma symreal function input(x) output(return)
double sum(double x) { return Weight<double>::of(x) + scaled(x) + plus(x); }

int main() { std::printf("%g\n", sum(0.5)); }
