// Under --decisions=auto a decision is a select where the source allows it, and costs no paths; elsewhere the ways
// are joined, or the paths recorded. A conversion, which has too many outcomes, is a guard. The report says what became of the decisions of each place.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=auto --json > %t/json 2> %t/table
// RUN: FileCheck %s < %t/table
// CHECK-NOT: warning
// CHECK: kernel mixed:
// CHECK: explored 2 paths, 1 select between them; complete but for the guards of pragmas and conversions
// CHECK: the ways from 1 decision came together: 4 pieces of a run, 2 selects
// CHECK: decision auto.cpp:[[#@LINE+33]]:5: select{{$}}
// CHECK-NEXT: decision auto.cpp:[[#@LINE+34]]:{{[0-9]+}}: select{{$}}
// CHECK-NEXT: decision auto.cpp:[[#@LINE+35]]:12: join and paths{{$}}
// CHECK-NEXT: decision auto.cpp:[[#@LINE+35]]:23: guard{{$}}
// CHECK-NEXT: guard 1 auto.cpp:[[#@LINE+34]]:23: the conversion of n to int gives 1{{$}}
// CHECK-NOT: guard {{[0-9]}}
// CHECK: kernel selected:
// CHECK: explored 1 path, 0 selects between them; complete: no guards
// CHECK-NEXT: decision auto.cpp:[[#@LINE+37]]:{{[0-9]+}}: select{{$}}
// RUN: FileCheck %s --check-prefix=JSON < %t/json
// JSON: "decisions": [
// JSON-NEXT: {
// JSON-NEXT: "file": "{{.*}}auto.cpp"
// JSON: "select": true,
// JSON-NEXT: "join": false,
// JSON-NEXT: "paths": false,
// JSON-NEXT: "guard": false
// RUN: %symreal verify --samples=100 --min-samples=10 %s mixed.c selected.c > %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SAME < %t/verified
// SAME: kernel mixed, mode finite
// SAME: refused by a guard: {{[1-9]}}
// SAME: value_return 1 0 0{{$}}
// SAME: kernel selected, mode finite
// SAME: no sample is left to a guard
// SAME: value_return 1 0 0{{$}}
#include <algorithm>
#include <cmath>
#include <cstdio>

#pragma symreal function input(x[0:6], n) range(-2, 2) output(return)
double mixed(double const *x, double n) {
  double y[6], sum = 0;
  for (int i = 0; i < 6; ++i) {
    if (x[i] > 0) y[i] = x[i];
    else y[i] = -0.5 * x[i];
    sum += x[i] > 1 ? x[i] : 1;
  }
  std::sort(y, y + 3);
  for (int i = 0; i < (int)n; ++i) sum += y[i % 6];
  return sum + y[0] * 2 - y[2];
}

#pragma symreal function input(x, y) output(return)
double selected(double x, double y) {
  if (x > y) return x * x;
  return y - x;
}

int main() {
  double x[6] = {1, -2, 3, 1, 2, 3};
  std::printf("%g %g\n", mixed(x, 1.5), selected(1, 2));
}
