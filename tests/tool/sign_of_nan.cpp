// The sign of a NaN that is a constant stays, through the recording's text and in generated code. That of one that an
// operation makes is left open by C: samples at which it is seen are left out.
// RUN: %symreal generate %s -o %t.c --fp=strict 2>/dev/null && FileCheck %s --input-file=%t.c
// RUN: %symreal verify %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -c %t.c -o %t.o
// RUN: %clang -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -c %t.c -o %t.o
#include <cmath>
#include <cstdio>

// CHECK: copysign(input[0], {{-?}}NAN)
// CHECK: copysign(input[0]*2.0, -NAN)
// CHECK: copysign(input[0]*4.0, NAN)
// CHECK: copysign(1.0, sqrt(input[0]))
// SAME: left out: {{[1-9][0-9]*}} on which the original's behaviour is undefined
// SAME: y[0] 4 0 0
#pragma symreal function input(x) output(y[0:4])
void signs(double x, double *y) {
  y[0] = std::copysign(x, std::log(-1.0));
  y[1] = std::copysign(2 * x, -std::nan(""));
  y[2] = std::copysign(4 * x, std::nan(""));
  y[3] = std::copysign(1.0, std::sqrt(x));
}

int main() {
  double y[4];
  signs(2.0, y);
  std::printf("%g %g %g %g\n", y[0], y[1], y[2], y[3]);
}
