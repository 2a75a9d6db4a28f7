// Operands that change what the other reads are evaluated in the order of the original.
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s
// RUN: %cxx %s -o %t.orig && %symreal-c++ %s -o %t.exe && %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: %if all %{ %cxx -std=c++14 %s -o %t.orig && %symreal-c++ -std=c++14 %s -o %t.exe && %t.orig > %t.plain && %t.exe | diff %t.plain - %}
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --min-samples=20 --samples=100
#include <cmath>
#include <cstdio>

static double state;
static double next() { return state = state * 3.0 + 1.0; }
static double weigh(double a, double b) { return a - 7.0 * b; }
template <class T> T difference(T (*make)()) { return make() - T(2) * make(); }
struct Generator {
  double seed;
  double draw() { return seed = seed * 1.5 + 0.25; }
  double peek() const { return seed; }
};
struct Two {
  double a, b;
  Two(double one, double other) : a(one), b(other) {}
};
static double add(double *sum) { return *sum += 1.0; }
static double table[8];
static int place() {
  state = state * 2.0;
  return 0;
}
static double *row() {
  state = state + 1.0;
  return table;
}

#pragma symreal function input(x[0:2]) output(y[0:16]) scratch(state, table[0:8])
void compute(double const *x, double *y) {
  state = x[0];
  // CHECK: = next() - REAL_LATER(2.0 * next());
  y[0] = next() - 2.0 * next();
  state = x[0];
  y[1] = state - next();
  state = x[0];
  y[2] = next() - 2.0 * state;
  state = x[0];
  y[3] = state + next();
  state = x[0];
  y[4] = weigh(next(), next());
  state = x[0];
  // CHECK: = weigh(next(), REAL_NOW(
  y[5] = weigh(next(), state);
  state = x[0];
  y[6] = next() / next();
  state = x[0];
  y[7] = difference<double>(next);
  Generator g{x[1]}, h{x[0]};
  y[8] = g.draw() / h.draw() - g.draw() * g.peek();
  double sum = x[0];
  y[9] = 2.0 * sum - add(&sum);
  state = x[0];
  Two const two(next(), state);
  y[10] = two.a - 3.0 * two.b;
  state = x[0];
  Two const braced{state, next()};
  y[11] = braced.a - 3.0 * braced.b;
  state = x[0];
  table[1] = x[1];
  y[12] = row()[1] - next();
  state = x[0];
  row()[place()] = next();
  y[13] = table[0];
  state = x[0];
  y[14] = std::atan2(next(), state) * next();
  state = x[0];
  y[15] = next() * next() + state;
  double const a = x[0], b = x[1];
  // CHECK: REAL const plain = a * std::sin(b) + std::sqrt(a) * b;
  double const plain = a * std::sin(b) + std::sqrt(a) * b;
  y[15] += plain;
}

int main() {
  double x[2] = {5.3, 2.0}, y[16];
  compute(x, y);
  for (double each : y) std::printf("%.17g\n", each);
}
