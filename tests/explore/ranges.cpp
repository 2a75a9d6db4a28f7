// Conditions that bounds settle are explored on one side only: by the operations alone without a guard, by the range of
// an input with one, which refuses an input beyond it. Conditions are known in any spelling.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=explore --explore=joins=off 2> %t/table
// RUN: FileCheck %s < %t/table
// CHECK-NOT: warning
// CHECK: kernel zone:
// CHECK: explored 3 paths, {{[0-9]+}} selects between them; complete but for
// CHECK-NEXT: 3 decisions on these paths followed from earlier ones
// CHECK-NEXT: 1 condition beyond the range of an input taken as not met
// CHECK: guard 1 ranges.cpp:[[#@LINE+19]]:{{[0-9]+}}: latitude > 84 is false
// CHECK-NOT: guard 2
// CHECK: kernel spelled:
// CHECK: explored 2 paths, 1 select between them; complete: no guards
// CHECK-NEXT: 8 decisions on these paths followed from earlier ones
// RUN: %symreal verify %s zone.c spelled.c > %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SAME < %t/verified
// SAME: kernel zone, mode finite: 1000 samples
// SAME: value_return 1 0 0{{$}}
// SAME: kernel spelled, mode finite: 1000 samples
// SAME: value_return 1 0 0{{$}}
#include <cmath>
#include <cstdio>

#pragma symreal function input(latitude) range(-80, 80) output(return)
double zone(double latitude) {
  double const square = latitude * latitude;
  if (std::fabs(latitude) < -1) return -1; // never
  double band = 0;
  if (latitude > 84) band = 2; // beyond the range
  if (latitude < 0) band = -1;
  else if (latitude > 40) band = 1;
  return square + band;
}

// One decision, four times asked again.
#pragma symreal function input(a, b) output(return)
double spelled(double a, double b) {
  double sum = a < b ? 1 : 2;
  if (b > a) sum += a;
  if (!(a >= b)) sum += 4;
  if (b <= a) sum += b;
  if (!(b > a)) sum += 0.5;
  return sum;
}

int main() { std::printf("%g %g\n", zone(10), spelled(1, 2)); }
