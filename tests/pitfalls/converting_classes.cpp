// Classes that convert to double or from it: the language takes one step of a user's, and REAL would be a second.
// RUN: %symreal generate %s -o %t.c --decisions=select && %symreal verify --samples=100 --min-samples=10 %s %t.c
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s
#include <cstdio>
#include <vector>

struct Quantity {
  double v;
  operator double() const { return v; }
};
struct Angle {
  double v;
  Angle(double d = 0) : v(d) {}
};
struct Switch {
  bool on;
  operator bool() const { return on; }
};
struct Pair {
  double a, b;
  Pair(int n) : a(n), b(2 * n) {}
};
static Pair operator*(Pair const &p, double const &d) {
  Pair r(0);
  r.a = p.a * d;
  r.b = p.b * d;
  return r;
}
static double turned(Angle a) { return a.v; }

#pragma symreal function input(x[0:4]) output(y[0:5])
void kernel(double const *x, double *y) {
  int n = 3;
  Quantity q{x[0]};
  // CHECK: y[0]) = REAL_TO(REAL, q)*REAL_C(2) + 3 / REAL_TO(REAL, q);
  y[0] = q*2 + 3 / q;
  if (q > 0.2) y[0] += x[1];
  Angle a = n, many[] = {1, 2.0, n};
  a = 1.5;
  y[1] = turned(1e-3) * x[0] + turned(n) + a.v * x[1] + many[0].v + many[1].v * x[2] + many[2].v;
  // CHECK: REAL_C(5) *
  y[2] = 5 * x[3] + (Pair(2) * x[0]).b;
  std::vector<bool> const flags{true, false};
  y[3] = x[3];
  y[3] += flags[0];
  y[4] = x[2] * Switch{true} + q * q;
}
int main() {
  double const x[] = {0.75, 1.5, 2.25, 0.5};
  double y[5];
  kernel(x, y);
  std::printf("%g\n", y[0]);
}
