// The kernels beside those that are asked for run as plain code: what they leave behind, or decide, is not reported, and the
// program ends where the last one asked for does.
// RUN: rm -rf %t && mkdir %t && cd %t
// DEFINE: %{name} =
// DEFINE: %{one} = cd %t && %symreal generate %s -o %{name}.c --kernel %{name} > log 2>&1 && FileCheck %s --input-file=log --implicit-check-not=error: --implicit-check-not=warning: && %symreal verify %s %{name}.c --samples=100
// CHECK: kernel {{area|square}}:
// REDEFINE: %{name} = area
// RUN: %{one}
// REDEFINE: %{name} = square
// RUN: %{one}
// RUN: cd %t && %symreal generate %s -o explored.c --kernel area --decisions=explore -- -DENDLESS
// RUN: cd %t && %symreal generate %s -o area.c --kernel area --wrapper
// RUN: cd %t && %symreal verify %s area.c square.c --samples=100 2>&1 | FileCheck %s --check-prefix=TRIED
// TRIED: the wrapper was tried as well
// RUN: %symreal oracle %s --kernel area -- -DLATE

// By a call on the command line as well, which runs another one when the program starts.
// RUN: cd %t && %symreal generate %s -o called.c --kernel 'plain(x=2) -> return' && %symreal verify %s called.c --kernel 'plain(x=2) -> return' --samples=100

// Kernels that are asked for are reported.
// RUN: not %symreal generate %s -o %t/other.c --kernel stored -- -DLATE 2>&1 | FileCheck %s --check-prefix=STORED --implicit-check-not=error:
// STORED: kernels_not_asked.cpp:[[# @LINE+10]]:15: error: the kernel writes 'total', which is not an output [SYM053]
// RUN: not %symreal generate %s -o %t/other.c --kernel add -- -DLATE 2>&1 | FileCheck %s --check-prefix=ADD --implicit-check-not=error:
// ADD: error: the kernel writes 'sum', which is not an output [SYM053]
// RUN: not %symreal generate %s -o %t/other.c --kernel summed -- -DLATE 2>&1 | FileCheck %s --check-prefix=SUMMED --implicit-check-not=error:
// SUMMED: error: the kernel writes 'total', which is not an output [SYM053]
// RUN: not %symreal generate %s -o %t/ -- -DLATE 2>&1 | FileCheck %s --check-prefix=ALL
// ALL: [SYM053]
// ALL: [SYM016]
#include <cstdio>

static double total;

#pragma symreal function input(x) output(return)
double stored(double x) {
  total += x;
  return x * total;
}

struct Sum {
  double sum = 0;
#pragma symreal function input(x) output(return)
  double add(double x) {
    sum += x;
    return x * 3;
  }
};

#pragma symreal function input(x) output(return)
double decided(double x) { return x < 0 ? -x : x * x; }

#pragma symreal function input(x, y) output(return)
double area(double x, double y) { return x * y + 1; }

double plain(double x) { return 3 * x; }

double summed(double x) {
  double y;
#pragma symreal input(x)
  total += x;
  y = x * total;
#pragma symreal output(y) generate("summed.c")
  return y;
}

#ifndef LATE
static double const before = stored(2) + decided(1);
#endif

int main() {
#ifdef LATE
  double const before = stored(2) + decided(1);
#endif
  Sum sum;
  double const others = summed(1) + sum.add(2) + decided(3) + before;
  double x = area(2, others), z;
#pragma symreal input(x)
  z = x * x;
#pragma symreal output(z) generate("square.c")
  if (stored(plain(z)) > 1e9) std::printf("%g\n", total);
#ifdef ENDLESS
  for (;;) std::printf("%g\n", z);
#endif
}
