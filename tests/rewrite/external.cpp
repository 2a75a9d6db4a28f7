// An external function keeps its declaration, and each call says how it is recorded.
// RUN: cd %S && %rewrite external.cpp | FileCheck external.cpp
// RUN: %same %s
enum { dimension = 3 };
struct State { double q[2]; double v; };

extern "C" {
// The declarations stay.
// CHECK: double energy(double const *q, int n);
double energy(double const *q, int n);
// CHECK-NEXT: State next(State s, State const *target, double in_out[3], double (*m)[2], unsigned char flag);
State next(State s, State const *target, double in_out[3], double (*m)[2], unsigned char flag);
}
namespace lib { extern "C" int status(double x) noexcept; }
#pragma symreal external(energy) pure input(q[0:n])
#pragma symreal external(next) input(in_out, m[0:dimension][0:2]) output(in_out)
#pragma symreal external(lib::status)
// The pragma may stand before the declaration.
#pragma symreal external(later) \
    input(x[0:4]) pure
extern "C" void later(double *x);

double f(double x) {
  double q[2] = {x, 1}, a[3] = {x, x, x}, m[3][2] = {};
  State s = {{x, 2}, 3};
  // CHECK: s = REAL_EXTERNAL(next, "next", false, "returns object 3 takes object 3 input 3 updated 3 updated 6 integer \"unsigned char\"", "", "external.cpp", 12, 7)(s, &s, a, m, 1);
  s = next(s, &s, a, m, 1);
  // CHECK: REAL_EXTERNAL(later, "later", true, "takes updated 4", "", "external.cpp", 21, 17)(&a[0]);
  later(&a[0]);
  // CHECK: if (REAL_EXTERNAL(lib::status, "status", false, "returns integer \"int\" takes number", "", "external.cpp", 14, 32)(0.5) != 0) return 0.0;
  if (lib::status(0.5) != 0) return 0.0;
  // CHECK: return REAL_EXTERNAL(energy, "energy", true, "returns number takes input 1 integer \"int\"", "1*$1 0", "external.cpp", 10, 8)(q, 2) + a[0] + s.v;
  return energy(q, 2) + a[0] + s.v;
}
