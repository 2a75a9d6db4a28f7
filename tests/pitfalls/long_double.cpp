// What is computed in long double is not recorded: a REAL gets there only while it is an ordinary number.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
// RUN: not %symreal rewrite --diff %s -- -DASSIGNS 2>&1 | FileCheck %s --check-prefix=ASSIGNS
// RUN: %symreal-c++ -DORDINARY %s -o %t.exe && %cxx -DORDINARY %s -o %t.orig && %t.exe > %t.out && %t.orig | diff %t.out -
#include <cstdio>

static long double total = 0.0L;

#ifndef ORDINARY
#pragma symreal function input(x) output(return)
#endif
double sum(double x) {
  long double y = 1.0L / 3;
  // CHECK-DAG: long_double.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of x
  y += x;
  // CHECK-DAG: long_double.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of x * 2
  total = x * 2.0;
  // CHECK-DAG: long_double.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of x
  return static_cast<double>(y * x + static_cast<long double>(x));
}

#ifdef ASSIGNS
// ASSIGNS: long_double.cpp:[[@LINE+1]]:{{[0-9]+}}: error: a REAL is changed by what is computed in long double [SYM036]
double assigned(double x) { return x *= total; }
#endif

int main() {
  std::printf("%.17g\n", sum(0.1));
  double x = 0.1;
  long double z = x;
  std::printf("%.20Lg %.20Lg\n", z / 3, total + x);
}
