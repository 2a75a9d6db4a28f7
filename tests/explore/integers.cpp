// An integer that a function returns is an output: a number that has the integer's values. Where paths return other
// integers it is a select between constants.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=explore > %t/told 2>&1
// RUN: FileCheck %s < %t/told
// CHECK-NOT: {{warning|error}}
// CHECK: kernel class_of:
// CHECK: explored {{.*}}; complete: no guards
// CHECK: kernel inside:
// CHECK: explored {{.*}}; complete: no guards
// CHECK: kernel cell:
// CHECK-NOT: {{explored|guard}}
// CHECK: kernel state_of:
// CHECK: explored {{.*}}; complete: no guards
// RUN: FileCheck %s --check-prefix=CLASS < class_of.c
// CLASS: void compute(
// CLASS: ? {{.*}}2.0
// RUN: FileCheck %s --check-prefix=INSIDE < inside.c
// INSIDE: input[1]*input[1] + input[0]*input[0] < 1.0 ? 1.0 : 0.0;
// RUN: %symreal verify --samples=100 --min-samples=10 %s class_of.c inside.c cell.c state_of.c > %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SAME < %t/verified
// SAME: kernel class_of, mode finite
// SAME: value_return 1 0 0{{$}}
// SAME: kernel inside, mode finite
// SAME: value_return 1 0 0{{$}}
// SAME: kernel cell, mode finite
// SAME: value_return 1 0 0{{$}}
// SAME: kernel state_of, mode finite
// SAME: value_return 1 0 0{{$}}
// SAME: y 1 0 0{{$}}
// One of the constants is another.
// RUN: sed 's/2[.]0/3.0/' class_of.c > wrong.c
// RUN: not %symreal verify --samples=100 --min-samples=10 %s wrong.c 2>&1 | FileCheck %s --check-prefix=WRONG
// WRONG: outputs differ from the original [SYM091]

// The wrapper returns the integer.
// RUN: %symreal generate %s --kernel class_of -o wrapped.c --decisions=explore --wrapper
// RUN: FileCheck %s --check-prefix=WRAPPER < wrapped_wrapper.cpp
// RUN: %symreal verify --samples=100 --min-samples=10 %s wrapped.c --kernel class_of 2>&1 | FileCheck %s --check-prefix=TRIED
// WRAPPER: int class_of(double x, double y)
// WRAPPER: return (int)symreal_output[0];
// TRIED: the wrapper was tried as well

// More than 32 bits are too many.
// RUN: not %tool generate %s -o no.c --decisions=explore -- -DWIDE 2>&1 | FileCheck %s --check-prefix=WIDE
// WIDE: integers.cpp:[[#@LINE+38]]:{{[0-9]+}}: error: 'wide' returns an integer of more than 32 bits, which no output holds [SYM026]
// RUN: not ls no.c
#include <cmath>
#include <cstdio>

// Paths differ in what they leave on the stack as well.
#pragma symreal function input(x, y) range(-2, 2) output(return)
int class_of(double x, double y) {
  int n = 0;
  if (x > 0) ++n;
  if (y > 0) ++n;
  if (n == 2 && x > y) return -1;
  return n;
}

// A truth value is 1 or 0.
#pragma symreal function input(x, y) range(-2, 2) output(return)
bool inside(double x, double y) { return x * x + y * y < 1; }

// An integer in a local variable is no decision.
#pragma symreal function input(x) range(0, 100) parameter(h) output(return)
unsigned short cell(double x, double h) {
  int i = (int)(x / h);
  return i + 1;
}

enum class State { low, high = 7 };
#pragma symreal function input(x) range(-2, 2) output(*y, return)
State state_of(double x, double *y) {
  if (x > 1) {
    *y = x * x;
    return State::high;
  }
  *y = -x;
  return State::low;
}

#ifdef WIDE
#pragma symreal function input(x) output(return)
long wide(double x) { return x > 0; }
#endif

int main() {
  double y;
  std::printf("%d %d %d\n", class_of(0.5, 1), inside(0.25, 0.5), cell(3.75, 0.5));
  std::printf("%d\n", int(state_of(0.5, &y)));
#ifdef WIDE
  std::printf("%ld\n", wide(1));
#endif
}
