// The compiler may have used the value of a const object before the program begins: such an object is no input.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdio>

double const gravity = 9.81;
static const double gains[2] = {1.0, 2.0};

#pragma symreal function input(x, gains[0:2]) parameter(gravity) output(return)
double weigh(double x) { return x * gravity + gains[1]; }

int main() {
  double const mass = 2.0;
  double force;
  // CHECK-DAG: const_input.cpp:[[@LINE+1]]:{{[0-9]+}}: error: 'mass' is const: the compiler may have used its value already [SYM026]
#pragma symreal input(mass)
  force = mass * 9.81;
#pragma symreal output(force) generate("force.c")
  std::printf("%g %g\n", weigh(0.5), force);
}

// CHECK-DAG: const_input.cpp:9:{{[0-9]+}}: error: 'gravity' is const
// CHECK-DAG: const_input.cpp:9:{{[0-9]+}}: error: 'gains[0:2]' is const
