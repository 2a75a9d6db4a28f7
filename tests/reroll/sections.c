// Mode fast: equal expressions are one up to their signs, and what alternates in the recovered graph does not in the
// loop. Straight-line code before it goes by the loop, which needs no table.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s --reroll --fp=fast -o %t/sections.c --mainline
// RUN: FileCheck %s --input-file=%t/sections.c
// CHECK: for (int k = 0; k < 197; ++k) {
// CHECK-NOT: row
// CHECK: input[k + 3] - t{{[0-9]+}}*0.5;
// CHECK-NOT: row
// CHECK: {{^  [}]$}}
// RUN: %symreal verify %s %t/sections.c --samples=100 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: mode fast: 100 samples, 100 within the premises
// RUN: %cc -std=c99 -w -O2 -ffp-contract=off %t/sections.c %t/sections_main.c -lm -o %t/run
// RUN: %cc -w -O2 -ffp-contract=off %s -o %t/original
// RUN: %t/run | sed 's/.*= //' | xargs -n 1 printf "%%.9f\n" > %t/generated.txt
// RUN: %t/original | xargs -n 1 printf "%%.9f\n" | diff - %t/generated.txt
#include <stdio.h>

#pragma symreal function input(x[0 : 200]) output(y[0 : 200])
void filter(double const *x, double *y) {
  double state[2][2] = {{0}};
  for (int k = 0; k < 200; k++) {
    double value = x[k];
    for (int section = 0; section < 2; section++) {
      double *const s = state[section];
      double const next = value - 0.5 * s[0] + 0.25 * s[1];
      value = 0.3 * next + 0.6 * s[0] + 0.3 * s[1];
      s[1] = s[0];
      s[0] = next;
    }
    y[k] = value;
  }
}

int main(void) {
  double x[200], y[200];
  for (int k = 0; k < 200; ++k) x[k] = 1.0 / (k + 1);
  filter(x, y);
  for (int k = 0; k < 200; ++k) printf("%.17g\n", y[k]);
}
