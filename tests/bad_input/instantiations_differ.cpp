// Two instantiations on REAL that chose functions of different types.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdio>

struct Value {
  double v;
  Value(double x) : v(x) {}
};
static double f(int i, int) { return 10.0 * i; }
static double f(short i, char *) { return 20.0 * i; }
static double f(Value const &value, ...) { return value.v; }
// CHECK: instantiations_differ.cpp:[[@LINE+1]]:63: error: 'x' is converted to int in one instantiation and to short in another [SYM134]
template <class T, class U> double g(T x, U other) { return f(x, other); }

int main() {
  double x = 1.0, y;
  char text[2] = "a";
#pragma symreal input(x)
  y = g(x, 1) + g(x, text);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
