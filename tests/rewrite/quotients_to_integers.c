// An integer of numbers beside a double gives a number, which the program may convert back by itself, in C and in C++.
// RUN: %symreal generate %s -o %t.c --decisions=guard && FileCheck %s < %t.c
// RUN: %symreal verify --samples=100 --min-samples=1 %s %t.c 2>&1 | FileCheck %s --check-prefix=VERIFY
// RUN: cp %s %t.cpp && %symreal generate %t.cpp -o %t.cxx.c --decisions=guard && FileCheck %s < %t.cxx.c
// RUN: %symreal verify --samples=100 --min-samples=1 %t.cpp %t.cxx.c 2>&1 | FileCheck %s --check-prefix=VERIFY
// CHECK: to_int32(input[2]*4.0)
// CHECK: to_int64(to_int32(input[0]*3.0)/3.0 - 0.25)
// VERIFY: value_return {{ *}}1 {{ *}}0 {{ *}}0
#include <math.h>

#pragma symreal function input(x, y, z) range(-2, 2) output(return)
double k(double x, double y, double z) {
  int const n = (x >= 0.5) + (int)(y - z > 0) + (int)(4 * z);
  int const quotient = (n + n) / 3.0;
  int const product = 2.5 * ((x >= 0.5) + (y - z > 0));
  long assigned = 0;
  assigned = (int)(3 * x) / 3.0 - 0.25;
  float const negative = -((x > 1) - (y > 1)) * 1.5;
  int const root = sqrt(1 + (x > y)) * 2, truth = (n > 1) * 3.0, choice = (x > y ? 1 : 2) * 1.5;
  int const chosen = n > 1 ? 1.5 : 2.5;
  double const arm = x > 0.25 ? n : 2.0;
  int compound = 7;
  compound -= ((x > 1) + 2) / 0.75;
  return x + quotient + product + assigned + negative + root + truth + choice + chosen + arm + compound;
}

int main(void) { return k(0.3, 0.5, 0.2) > 100; }
