// A C source is compiled as C++: there the declaration says that the function has its C name.
// RUN: cd %S && %rewrite external.c | FileCheck external.c
// RUN: %same %s
typedef struct { double x, y; } point;
#define COUNT 4
// CHECK: REAL_LINKAGE(extern double norm(point const *p));
extern double norm(point const *p);
// CHECK: REAL_LINKAGE(void shift(double *values));
void shift(double *values);
#pragma symreal external(norm) pure
#pragma symreal external(shift) input(values[0:4]) output(values)

double f(double x) {
  point p = {1, 2};
  double values[COUNT] = {0};
  p.x = x;
  // CHECK: REAL_EXTERNAL(shift, "shift", false, "takes updated 4", "", "external.c", 9, 6)(values);
  shift(values);
  return norm(&p) + values[0];
}
