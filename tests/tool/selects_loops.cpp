// Loops that are left on a REAL are bounded, by a break or by their condition.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/step.c
// RUN: %symreal verify %s %t/step.c --samples 3000 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: {{(29|30)[0-9][0-9]}} within the premises
// SAME: out[0] {{ *}}2 {{ *}}0 {{ *}}0{{$}}
#include <cmath>
#include <cstdio>
#pragma symreal function input(x, y) output(out[0:2]) decisions(select)
void step(double x, double y, double *out) {
  double E = x;
#pragma symreal loop(20)
  for (int k = 0; k < 50; ++k) {
    double d = (E - 0.3 * std::sin(E) - x) / (1 - 0.3 * std::cos(E));
    E -= d;
    if (std::fabs(d) < 1e-9) break;
  }
  out[0] = E;
  double f = 1 + std::fabs(y); int n = 0;
#pragma symreal loop(9)
  while (f > 1e-1 && n < 8) { f *= 0.3; n++; }
  out[1] = f;
}
int main() {
  double out[2];
  step(0.5, 0.25, out);
  std::printf("%g %g\n", out[0], out[1]);
}
