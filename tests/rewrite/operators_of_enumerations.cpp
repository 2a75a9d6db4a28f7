// A template's enumerator stays one where the program has operators for it: an integer would choose others.
// RUN: not %symreal generate %s -o %t.c -- -std=c++17 2>&1 | FileCheck %s
// CHECK: operators_of_enumerations.cpp:[[#@LINE+4]]:{{[0-9]+}}: error: the program does not compile in symbolic mode:
enum shade { dark = 1, light = 3 };
inline double operator+(shade a, shade b) { return static_cast<int>(a) + 10 * static_cast<int>(b); }

template <class... T> double sum(T... t) { return (t + ...); }

#pragma symreal function input(x) output(return)
double k(double x) { return x * sum(light) + sum(dark, light); }

int main() { return k(0.3) > 1e30; }
