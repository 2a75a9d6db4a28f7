// Decisions become selects: both arms are recorded, and the result is that of the original on both sides of each.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/step.c
// RUN: FileCheck %s --input-file=%t/step.c
// RUN: %symreal verify %s %t/step.c --samples 3000 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: {{29[0-9][0-9]|3000}} within the premises
// SAME: value_return {{ *}}1 {{ *}}0 {{ *}}0{{$}}
// SAME-NEXT: out[0] {{ *}}8 {{ *}}0 {{ *}}0{{$}}
// CHECK: compute(
// CHECK: int const [[POSITIVE:t[0-9]+]] = input[0] > 0.0;
// CHECK: ? sqrt(input[0]) : 4.0;
#include <algorithm>
#include <cmath>
#include <cstdio>
struct State { double v[3]; double w; };
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
double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
int isign(double x) { return (x > 0) - (x < 0); }
#pragma symreal function input(x, y) output(return) output(out[0:8]) decisions(select)
double step(double x, double y, double *out) {
  State s = {{1, 2, 3}, 4};
  if (x > 0 && y < 1) { s.v[0] = x; s.w = std::sqrt(x); } else { double t = x * y; s.v[1] += t; }
  if (!(x > 2)) for (int k = 0; k < 3; ++k) s.v[k] *= y;
  out[0] = s.v[0] + s.v[1] + s.v[2];
  out[1] = s.w;
  out[2] = sat(x, -1, 1) + lookup(y);
  out[3] = three(x, y);
  out[4] = sign(x) * y + x * (y > 0) + ((x > 0) - (x < 0));
  out[5] = std::max<double>(x, y) + std::clamp(x, -1.0, y > 0 ? y : 0.0) + std::max({x, y, 2.0});
  double E = x;
#pragma symreal loop(20)
  for (int k = 0; k < 50; ++k) {
    double d = (E - 0.3 * std::sin(E) - x) / (1 - 0.3 * std::cos(E));
    E -= d;
    if (std::fabs(d) < 1e-9) break;
  }
  out[6] = E;
  double f = 1 + std::fabs(y); int n = 0;
#pragma symreal loop(9)
  while (f > 1e-1 && n < 8) { f *= 0.3; n++; }
  out[7] = f;
  if (x < y) return x;
  return y;
}
int main() {
  double out[8];
  double r = step(0.5, 0.25, out);
  for (double o : out) std::printf("%g ", o);
  std::printf("%g\n", r);
}
