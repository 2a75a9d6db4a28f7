// Decisions become selects: both arms are recorded, and the result is that of the original on both sides of each.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/step.c
// RUN: FileCheck %s --input-file=%t/step.c
// RUN: %symreal verify %s %t/step.c --samples 3000 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: {{(29|30)[0-9][0-9]}} within the premises
// SAME: out[0] {{ *}}2 {{ *}}0 {{ *}}0{{$}}
// CHECK: compute(
// CHECK: bool const [[CHOSEN:t[0-9]+]] = (input[0] > 0.0) && (input[1] < 1.0);
// CHECK: [[CHOSEN]] ? sqrt(input[0]) : 4.0;
#include <cmath>
#include <cstdio>
struct State { double v[3]; double w; };
#pragma symreal function input(x, y) output(out[0:2]) decisions(select)
void step(double x, double y, double *out) {
  State s = {{1, 2, 3}, 4};
  if (x > 0 && y < 1) { s.v[0] = x; s.w = std::sqrt(x); } else { double t = x * y; s.v[1] += t; }
  if (!(x > 2)) for (int k = 0; k < 3; ++k) s.v[k] *= y;
  out[0] = s.v[0] + s.v[1] + s.v[2];
  out[1] = s.w;
}
int main() {
  double out[2];
  step(0.5, 0.25, out);
  std::printf("%g %g\n", out[0], out[1]);
}
