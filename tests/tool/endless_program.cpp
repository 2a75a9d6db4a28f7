// A program that never ends, as a controller's, is stopped when the kernels asked for are recorded, and verified.
// RUN: rm -rf %t && %symreal generate %s -o %t/
// RUN: %symreal verify %s %t/control.c %t/step.c --samples=50 2>&1 | FileCheck %s --implicit-check-not=not
// RUN: %symreal verify %s %t/setup.c --samples=50 2>&1 | FileCheck %s --check-prefix=SETUP
#include <cmath>
#include <cstdio>

#pragma symreal function input(x) output(return)
static double setup(double x) { return std::sqrt(1 + x * x); }

#pragma symreal function input(x, gain) output(return)
static double control(double x, double gain) { return gain * std::sin(x); }

// SETUP: kernel setup
// SETUP-NEXT: the program's next call was not compared: the program does not come to it within 7 s
// CHECK: kernel control
// CHECK: kernel step
int main() {
  double const gain = setup(2);
  double state = 0;
  for (;;) {
#pragma symreal input(state)
    double const next = state / 2 + 1;
#pragma symreal output(next) generate("step.c")
    state = control(next, gain);
    if (std::printf("%g\n", state) < 0) return 1;
  }
}
