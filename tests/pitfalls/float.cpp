// A REAL that is rounded to float: what is computed from there on is reported, not lost.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cmath>
#include <cstdio>

#pragma symreal function input(x) output(return)
double narrow(double x) {
  float y = x;
  double z = y * y;
  z += (float)(x * 2.0);
  return x + z + std::sqrt(static_cast<float>(x));
}

int main() { std::printf("%g\n", narrow(0.5)); }

// CHECK: float.cpp:9:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of x
// CHECK: float.cpp:11:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of
// CHECK: float.cpp:12:{{[0-9]+}}: error: the program decides on a symbolic value: the conversion of x
