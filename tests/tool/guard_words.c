// Guards are said as the source says them: the place first, the locals by their names, then in the inputs' names where
// these tell more. Of a chain of thresholds two are left.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/g.c --decisions=guard 2> %t/table
// RUN: FileCheck %s --check-prefix=H < %t/g.h
// H: 1 guard_words.c:[[#@LINE + 22]]:3: x[1] > 100 is false
// H-NEXT: 2 guard_words.c:[[#@LINE + 15]]:{{[0-9]+}}: load < limits[k] ((x[0] * 2) < 4) is false
// H-NEXT: 3 guard_words.c:[[#@LINE + 14]]:{{[0-9]+}}: load < limits[k] ((x[0] * 2) < 6)
// H-NEXT: 4 guard_words.c:[[#@LINE + 22]]:{{[0-9]+}}: the conversion of x[1] to int gives 2
// H: enum { guard_count = 4 };
// RUN: FileCheck %s --check-prefix=C < %t/g.c
// C: "guard_words.c:{{[0-9]+}}:3: x[1] > 100 is false",
// RUN: %symreal verify %s %t/g.c --min-samples 20 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: kernel f, mode finite: 1000 samples
// SAME: 1 {{[1-9][0-9]*}} guard_words.c:{{[0-9]+}}:3: x[1] > 100 is false
#include <stdio.h>

static int zone(double load) {
  static double const limits[6] = {1, 2, 3, 4, 6, 9};
  int k;
  for (k = 0; k < 6; ++k)
    if (load < limits[k]) break;
  return k;
}

#pragma symreal function input(x[0:2]) output(y[0:1])
void f(double const *x, double *y) {
  if (x[1] > 100) y[0] = 1;
  else y[0] = x[0];
  y[0] += zone(x[0] * 2);
  switch ((int)x[1]) {
  case 2: y[0] += 1;
  }
}

int main(void) {
  double x[2] = {2.5, 2.0}, y[1];
  f(x, y);
  printf("%g\n", y[0]);
  return 0;
}
