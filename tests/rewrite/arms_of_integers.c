// Integers of numbers as arms of a `?:` that stays one: in the element that an arm of a select assigns, and beside a
// plain integer.
// RUN: %symreal generate %s -o %t.c --decisions=guard && FileCheck %s < %t.c
// RUN: %symreal verify --samples=100 --min-samples=1 %s %t.c 2>&1 | FileCheck %s --check-prefix=VERIFY
// RUN: cp %s %t.cpp && %symreal generate %t.cpp -o %t.cxx.c --decisions=guard && FileCheck %s < %t.cxx.c
// RUN: %symreal verify --samples=100 --min-samples=1 %t.cpp %t.cxx.c 2>&1 | FileCheck %s --check-prefix=VERIFY
// CHECK: guard
// VERIFY: w[0] {{ *}}2 {{ *}}0 {{ *}}0

#pragma symreal function input(x, y) range(-2, 2) output(w[0:2])
void k(double x, double y, double *w) {
  int const n = -(-0.25 + x);
  w[0] = x, w[1] = y;
  if (x < 0.25 && 2.5 == 2.0)
    w[0] = 1;
  else
    w[(n - 3 < 0 ? 0 : n - 3 > 1 ? 1 : n - 3)] = y;
  int const is_three = w[0] == 3;
  int const plain = is_three ? 2 : (x > y) + (x > 1);
  int const nested = is_three ? (x > y) + 1 : x > 1 ? plain : (y > 1) * 2;
  long const wide = is_three ? (x > y) + (x > 1) : (x > y) + 3L;
  w[1] += plain + nested + wide;
}

int main(void) {
  double w[2];
  k(0.3, 0.5, w);
  return w[0] > 100;
}
