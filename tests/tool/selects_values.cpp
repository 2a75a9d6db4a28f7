// Comparisons as numbers, and functions of the library that choose a value.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/step.c
// RUN: %symreal verify %s %t/step.c --samples 3000 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: {{(29|30)[0-9][0-9]}} within the premises
// SAME: out[0] {{ *}}2 {{ *}}0 {{ *}}0{{$}}
#include <algorithm>
#include <cstdio>
double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
int isign(double x) { return (x > 0) - (x < 0); }
#pragma symreal function input(x, y) output(out[0:2]) decisions(select)
void step(double x, double y, double *out) {
  out[0] = sign(x) * y + x * (y > 0) + ((x > 0) - (x < 0));
  out[1] = std::max<double>(x, y) + std::clamp(x, -1.0, y > 0 ? y : 0.0) + std::max({x, y, 2.0});
}
int main() {
  double out[2];
  step(0.5, 0.25, out);
  std::printf("%g %g\n", out[0], out[1]);
}
