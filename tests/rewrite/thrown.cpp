// A literal that is thrown reaches the handler that takes a number.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && FileCheck %s --check-prefix=CODE < %t.c && %symreal verify %s %t.c
#include <cstdio>

static double factor(int steps) {
  try {
    // CHECK: if (steps > 3) throw REAL_THROWN(REAL, 2.5);
    if (steps > 3) throw 2.5;
    return 1.0;
  } catch (double largest) {
    return largest;
  }
}
void refuse(double x) {
  // CHECK: if (x > 1) throw x;
  if (x > 1) throw x;
  // CHECK: throw REAL_THROWN(bool, x < 0);
  throw x < 0;
}

// CODE: = input[0]*2.5;
#pragma symreal function input(x) output(return)
double scaled(double x) { return x * factor(4); }

int main() { std::printf("%g\n", scaled(0.5)); }
