// A return in an arm: what follows is the other arm.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/step.c
// RUN: %symreal verify %s %t/step.c --samples 3000 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: {{(29|30)[0-9][0-9]}} within the premises
// SAME: value_return {{ *}}1 {{ *}}0 {{ *}}0{{$}}
// SAME-NEXT: out[0] {{ *}}2 {{ *}}0 {{ *}}0{{$}}
#include <cstdio>
double sat(double x, double lo, double hi) {
  if (x > hi) return hi;
  if (x < lo) { return lo; }
  return x;
}
double lookup(double x) {
  static const double xs[] = {-1, 1, 2}, ys[] = {3, 5, 4};
  for (int i = 0; i < 2; ++i)
    if (x < xs[i + 1]) {
      double t = (x - xs[i]) / (xs[i + 1] - xs[i]);
      return ys[i] + t * (ys[i + 1] - ys[i]);
    }
  return ys[2];
}
double three(double x, double y) {
  double s = 1;
  if (x > 0) {
    if (y > 0) return x * y;
    s = y;
  } else if (y > 1)
    return s + y;
  else {
    s = 2;
  }
  return s * x;
}
#pragma symreal function input(x, y) output(return) output(out[0:2]) decisions(select)
double step(double x, double y, double *out) {
  out[0] = sat(x, -1, 1) + lookup(y);
  out[1] = three(x, y);
  if (x < y) return x;
  return y;
}
int main() {
  double out[2];
  double r = step(0.5, 0.25, out);
  std::printf("%g %g %g\n", out[0], out[1], r);
}
