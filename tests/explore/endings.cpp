// A path on which the program ends, loops for ever, or leaves the kernel by an exception comes to no end of the kernel: a guard
// refuses it.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=explore --explore=joins=off 2> %t/table
// RUN: FileCheck %s < %t/table
// CHECK: warning: of kernel 'checked' 3 paths are recorded, and 3 guards refuse what remains [SYM192]
// CHECK: note: on 3 paths the program ends before the kernel does
// CHECK: explored 3 paths
// CHECK: 0 cut off by the depth, 3 ended by the program, 0 not in time
// RUN: %symreal verify --samples=100 --min-samples=10 %s checked.c 2>&1 | FileCheck %s --check-prefix=SIDES
// SIDES: refused by a guard: {{[1-9]}}
// SIDES: value_return 1 0 0{{$}}
#include <cassert>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#pragma symreal function input(x, y) output(return)
double checked(double x, double y) {
  if (x > 1.5) throw std::domain_error("x");
  if (x < -1.5) std::exit(3);
  assert(y < 1.5);
  if (x < y) return x;
  return x > 0 ? x * y : x + y;
}

int main() {
  try {
    std::printf("%g\n", checked(0.5, 0.25));
  } catch (std::domain_error const &) {
    std::puts("caught");
  }
}
