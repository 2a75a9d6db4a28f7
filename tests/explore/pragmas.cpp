// Pragmas count within an explored kernel: selects are no decisions, guards stay guards on the paths that come by them, a
// loop with a bound is bounded, and a table is read at an index that depends on an input.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=explore --explore=joins=off 2> %t/table
// RUN: FileCheck %s < %t/table
// CHECK-NOT: warning
// CHECK: kernel mixed:
// CHECK: explored 3 paths, 2 selects between them; complete but for the guards of pragmas and conversions
// CHECK-NEXT: guard 1 pragmas.cpp:[[#@LINE+25]]:5: y < 1.5 where x > 0
// CHECK-NEXT: guard 2 pragmas.cpp:[[#@LINE+30]]:10: f > 0.3{{$}}
// CHECK-NOT: guard {{[0-9]}}
// CHECK: kernel look_up:
// CHECK: explored 2 paths, 1 select between them; complete: no guards
// RUN: %symreal verify --samples=100 --min-samples=10 %s mixed.c look_up.c > %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SAME < %t/verified
// SAME: kernel mixed, mode finite
// SAME: refused by a guard: {{[1-9]}}
// SAME: value_return 1 0 0{{$}}
// SAME: kernel look_up, mode finite
// SAME: no sample is left to a guard
// SAME: value_return 1 0 0{{$}}
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#pragma symreal function input(x, y) output(return)
double mixed(double x, double y) {
  double a[2] = {x, y};
#pragma symreal decisions(select)
  if (y > 0.25) a[1] = 2 * y;
  if (x > 0) {
#pragma symreal decisions(guard)
    if (y < 1.5) a[0] += 1;
  } else if (x > y) {
    std::swap(a[0], a[1]);
  }
  double f = 1 + std::fabs(y);
#pragma symreal loop(4) decisions(select)
  while (f > 0.3) f *= 0.5;
  return a[0] - f * a[1];
}

static double const curve[5] = {0, 1, 4, 9, 16}, other[5] = {5, 4, 3, 2, 1};
#pragma symreal function input(x, y) range(0, 3) output(return)
double look_up(double x, double y) {
  int i = std::clamp(static_cast<int>(x), 0, 3);
  double const *t = y > x ? curve : other;
  if (t == curve) return curve[i] + (x - i) * (curve[i + 1] - curve[i]);
  return other[i] * y;
}

int main() {
  std::printf("%g %g\n", mixed(1, 0.5), look_up(1.5, 2));
}
