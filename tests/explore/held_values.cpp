// On one path an output is set to the very number that it held before, which no address tells: the path is recorded again with
// another number there. An output that a path does not write is found.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/f.c --kernel written --decisions=explore --explore=joins=off 2>&1 | FileCheck %s
// CHECK: explored 3 paths, 3 selects between them; complete: no guards
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/f.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y[0] 2 0 0{{$}}
// RUN: %symreal generate %s -o %t/joined.c --kernel written --decisions=explore 2>&1 | FileCheck %s --check-prefix=JOINED
// JOINED: explored 1 path, 0 selects between them; complete: no guards
// JOINED: the ways from 1 decision came together
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/joined.c 2>&1 | FileCheck %s --check-prefix=SAME
// RUN: sed 's/y\[1\] = 0;/ /' %s > %t/unwritten.cpp
// RUN: not %symreal generate %t/unwritten.cpp -o %t/g.c --decisions=explore --explore=joins=off 2>&1 | FileCheck %s --check-prefix=KEPT
// KEPT: error: the kernel does not write output 'y[0:2]' in element 1, which keeps what it held before (0) [SYM136]
// RUN: not %symreal generate %t/unwritten.cpp -o %t/g.c --decisions=explore 2>&1 | FileCheck %s --check-prefix=KEPT
// RUN: not ls %t/g.c
#include <cstdio>

#pragma symreal function input(x) output(y[0:2])
void written(double x, double *y) {
  if (x > 1) {
    y[0] = 0;
    y[1] = 0;
  } else {
    y[0] = x < -1 ? -1 : x;
    y[1] = x * x;
  }
}

int main() {
  double y[2] = {0, 0};
  written(0.5, y);
  std::printf("%g %g\n", y[0], y[1]);
}
