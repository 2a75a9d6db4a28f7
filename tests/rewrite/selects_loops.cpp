// A bounded loop: the pragma's line says what is assigned, and the exits are marked.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
#include <cmath>
double kepler(double M, double e) {
  double E = M;
  // CHECK: REAL_LOOP(20, (E)){{$}}
  // CHECK-NEXT: for (int k = 0; REAL_TEST(k < 50); ++k) {
#pragma symreal loop(20)
  for (int k = 0; k < 50; ++k) {
    double d = (E - e * sin(E) - M) / (1 - e * cos(E));
    E -= d;
    // CHECK: REAL_BREAK(std::fabs(d) < 1e-12) break;
    if (std::fabs(d) < 1e-12) break;
  }
  double f = 1;
  int n = 0;
  // CHECK: REAL_LOOP(9, (f)){{$}}
  // CHECK-NEXT: while (REAL_TEST(std::fabs(f) > 1e-3 REAL_AND n < 30)) { f *= 0.5; n++; }
#pragma symreal loop(9)
  while (std::fabs(f) > 1e-3 && n < 30) { f *= 0.5; n++; }
  // CHECK: REAL_LATE_LOOP(8, (f)){{$}}
  // CHECK-NEXT: do { REAL_IF((f), f > 8) f = 8; f *= 0.75; } while (REAL_TEST(f > 0.1));
#pragma symreal loop(8)
  do { if (f > 8) f = 8; f *= 0.75; } while (f > 0.1);
  // CHECK: REAL_DECISIONS(guard) REAL_LOOP(5, (f)){{$}}
  // CHECK-NEXT: for (f = 2;REAL_TEST();) {
#pragma symreal decisions(guard) loop(5)
  for (f = 2;;) {
    f -= e;
    // CHECK: REAL_BREAK(f < 0) { break; }
    if (f < 0) { break; }
  }
  // CHECK: REAL_DECISIONS(select){{$}}
#pragma symreal decisions(select)
  if (E > 3) E = 3;
  return E + f;
}
// A function that is no kernel.
// CHECK: REAL helper(REAL x) { SYMREAL_DECISIONS(error) SYMREAL_RETURNS
#pragma symreal function decisions(error)
double helper(double x) {
  if (x > 0) return x;
  return 2;
}
