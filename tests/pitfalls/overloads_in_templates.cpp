// In a template and in a generic lambda REAL chooses the functions that double does, and converts as it does.
// RUN: %same %s -- -std=c++20
// RUN: %rewrite %s -- -std=c++20 | FileCheck %s
// RUN: grep -v "pragma symreal" %s > %t.plain.cpp
// RUN: %cxx -std=c++20 %t.plain.cpp -o %t.orig && %symreal-c++ -std=c++20 %t.plain.cpp -o %t.exe
// RUN: %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: %symreal generate %s -o %t.c -- -std=c++20 && %symreal verify %s %t.c --samples=100 -- -std=c++20
#include <algorithm>
#include <cstdio>

struct Value {
  double v;
  Value(double x) : v(x) {}
};
static double f(int i) { return 10.0 * i; }
static double f(Value const &value) { return value.v; }
struct Stream {
  double sum = 0;
  Stream &operator<<(long l) {
    sum += static_cast<double>(l);
    return *this;
  }
  Stream &operator<<(Value const &value) {
    sum += 100.0 * value.v;
    return *this;
  }
};
struct Made {
  double n;
  Made(float x) : n(static_cast<double>(x)) {}
  Made(Value const &value) : n(2.0 * value.v) {}
};
static double h(double, double) { return 1.0; }
static double h(double, int) { return 2.0; }

// CHECK: template <class T> REAL g(T x) { return f(REAL_ARGUMENT(int, x)); }
template <class T> double g(T x) { return f(x); }
template <class T> struct Box {
  T v;
  double value() const { return f(v); }
};
template <class T> double streamed(T x) {
  Stream stream;
  stream << x << x;
  return stream.sum;
}
template <class T> double made(T x) { return Made(x).n; }
template <class T> int whole(T x) {
  int i = x;
  return i;
}
template <class T> double with_literal(T x) { return h(x, 2.0) + std::max(x, 1.0); }
template <class T> double truth(T x) { return f(x > 1); }

#pragma symreal function input(x[0:2]) range(5.1, 5.9) output(y[0:8]) decisions(guard)
void compute(double const *x, double *y) {
  y[0] = g(x[0]) * x[1] + g(7);
  auto const call = [](auto q) { return f(q); };
  y[1] = call(x[0]) * x[1] + call(3L);
  y[2] = Box<double>{x[0]}.value() * x[1];
  y[3] = streamed(x[0]) * x[1];
  y[4] = made(2.6) * x[1]; // to float, which no guard can tell
  y[5] = whole(x[0]) * x[1];
  y[6] = with_literal(x[0]) * x[1];
  y[7] = truth(x[0]) * x[1];
}

int main() {
  double x[2] = {5.3, 5.5}, y[8];
  compute(x, y);
  for (double each : y) std::printf("%.17g\n", each);
}
