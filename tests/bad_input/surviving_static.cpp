// A static keeps a value of the first kernel for the second: a value of a recording that has ended is never used.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s

#include <cstdio>

template <class Number> struct Cache { // an object whose use is not seen where it is written
  static Number *value() {
    static Number last;
    return &last;
  }
};

void keep(double *place, double x) { *place = x; }

int main() {
  double a = 0.5, b = 0.25, y, z;
  double kept[1];
#pragma symreal input(a)
  kept[0] = a * a;
  y = kept[0] + 1.0;
  keep(Cache<double>::value(), a);
#pragma symreal output(y) generate("first.c")
#pragma symreal input(b)
  z = kept[0] + b;
#pragma symreal output(z) generate("second.c")
  std::printf("%g %g\n", y, z);
}

// CHECK-DAG: surviving_static.cpp:13:{{[0-9]+}}: error: the kernel writes '*place', which is not an output [SYM053]
// CHECK-DAG: surviving_static.cpp:24:{{[0-9]+}}: error: a value of another kernel or thread is used in this kernel [SYM054]
