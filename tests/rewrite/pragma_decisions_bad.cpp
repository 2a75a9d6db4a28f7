// Errors of decisions(...) and loop(N).
// RUN: not %rewrite %s 2>&1 | FileCheck %s
// CHECK-DAG: bad.cpp:[[@LINE+1]]:26: error: decisions takes error, guard, select or carry, not 'maybe' [SYM021]
#pragma symreal function decisions(maybe)
double one(double x) { return x; }
// CHECK-DAG: bad.cpp:[[@LINE+1]]:26: error: 'loop' does not belong in a function pragma [SYM021]
#pragma symreal function loop(3)
double two(double x) { return x; }
double three(double x, int n) {
  // CHECK-DAG: bad.cpp:[[@LINE+1]]:1: error: this pragma stands before a declaration
#pragma symreal decisions(guard)
  double y = x > 0 ? x : 1;
  // CHECK-DAG: bad.cpp:[[@LINE+1]]:17: error: loop(N) takes the largest number of runs, not 'n' [SYM021]
#pragma symreal loop(n)
  while (y > 1) y /= 2;
  // CHECK-DAG: bad.cpp:[[@LINE+1]]:1: error: no exit of this loop depends on a REAL [SYM048]
#pragma symreal loop(3)
  for (int k = 0; k < n; ++k) y += 1;
  // CHECK-DAG: bad.cpp:[[@LINE+1]]:1: error: no loop follows this pragma [SYM048]
#pragma symreal loop(3)
  y += 1;
  // CHECK-DAG: bad.cpp:[[@LINE+1]]:1: error: 'z' must be declared before the loop [SYM048]
#pragma symreal loop(3)
  for (double z = 1; z > 0; z -= x) y += z;
  int count = 0;
  // CHECK-DAG: bad.cpp:[[@LINE+1]]:1: error: the loop has an assignment to 'count', which is not a REAL [SYM048]
#pragma symreal loop(3)
  while (y > 1) { y /= 2; ++count; }
  if (n > 1)
    // CHECK-DAG: bad.cpp:[[@LINE+1]]:1: error: this pragma stands within a statement [SYM024]
#pragma symreal decisions(guard)
    y = 2;
  // CHECK-DAG: bad.cpp:[[@LINE+1]]:38: error: 'decisions' applies to the next statement and needs a pragma of its own [SYM021]
#pragma symreal input(x) range(1, 2) decisions(guard)
  y += x;
  return y + count;
  // CHECK-DAG: bad.cpp:[[@LINE+1]]:1: error: no statement follows this pragma [SYM024]
#pragma symreal decisions(guard)
}
// CHECK-DAG: bad.cpp:[[@LINE+1]]:1: error: this pragma stands where no statement can stand [SYM024]
#pragma symreal decisions(guard)
double four;
