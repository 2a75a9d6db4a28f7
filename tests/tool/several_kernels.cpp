// Several kernels in one program: each has a graph and a file of its own in the directory that -o names.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/all
// RUN: ls %t/all | FileCheck %s --check-prefix=FILES
// FILES: cube.c
// FILES: cube.h
// FILES: square.c
// FILES: square.h
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/all/cube.c %t/all/square.c > %t.log 2>&1
// RUN: FileCheck %s --check-prefix=BOTH < %t.log
// BOTH: kernel cube
// BOTH: kernel square
// RUN: sed 's/= \(.*\)\*/= \1+/' %t/all/cube.c > %t/all/changed.c
// RUN: python3 %tools/expect_status.py 3 %symreal verify --samples=100 --min-samples=10 %s %t/all/changed.c %t/all/square.c > %t.log 2>&1
// RUN: FileCheck %s --check-prefix=ONE < %t.log
// ONE: {{.*}}changed.c: error: 1 of 1 outputs differ
// ONE: kernel square
//
// RUN: %symreal generate %s --kernel cube -o %t/one.c
// RUN: FileCheck %s --check-prefix=CUBE < %t/one.c
// CUBE: "kernel":"cube"
// RUN: %symreal generate %s --kernel "cube, square" -o %t/all --check
// RUN: not %symreal generate %s --kernel cube,sphere -o %t/none.c 2>&1 | FileCheck %s --check-prefix=SPHERE
// SPHERE: error: no kernel is named 'sphere'; there are: {{.*}}[SYM013]
// RUN: ls %t | count 3
#include <cstdio>

#pragma symreal function input(x) output(return)
double cube(double x) { return x * x * x; }

int main() {
  double x = 3, y;
#pragma symreal input(x)
  y = x * x;
#pragma symreal output(y) generate("square.c")
  std::printf("%g %g\n", y, cube(2));
}
