/* Of a kernel in a block, the branches between its annotations count, in each round of a loop around it, and not those
   before and behind.
RUN: rm -rf %t && mkdir %t
RUN: %symreal generate %s -o %t/k.c --decisions=guard
RUN: %symreal verify %s %t/k.c --branches 2>&1 | FileCheck %s --implicit-check-not ": never true" --implicit-check-not ": never false"
CHECK: branches of the original: 7 of 12 directions taken by some sample
CHECK-NEXT: verify_branches_block.c:[[#@LINE + 25]]:10: never true: x > 90
CHECK-NEXT: verify_branches_block.c:[[#@LINE + 34]]:7: never true: case 1
CHECK-NEXT: verify_branches_block.c:[[#@LINE + 34]]:7: never false: default
CHECK-NEXT: verify_branches_block.c:[[#@LINE + 36]]:11: never false: mode == 2
CHECK-NEXT: verify_branches_block.c:[[#@LINE + 35]]:24: never true: x < 0.25

A program that clang does not compile is verified all the same, and what could not be counted is said, in each form of the
result.
RUN: %symreal generate %s -o %t/g.c --decisions=guard -- -DONLY_GCC
RUN: %symreal verify %s %t/g.c --branches --certificate %t/c.json -- -DONLY_GCC 2>&1 | FileCheck %s --check-prefix=BUILD
RUN: FileCheck %s --check-prefix=JSON < %t/c.json
RUN: %symreal verify %s %t/g.c --check %t/c.json -- -DONLY_GCC 2>&1 | FileCheck %s --check-prefix=BUILD
BUILD: branches of the original: not counted: clang-19 does not build the original: {{.*}}unknown directive
JSON: "branches": {
JSON-NEXT: "obstacle": "clang-19 does not build the original

RUN: %symreal generate %inputs/rotation/rotation_symbolic.cpp -o %t/r.c
RUN: %symreal verify %inputs/rotation/rotation_symbolic.cpp %t/r.c --branches 2>&1 | FileCheck %s --check-prefix=HAND
HAND: branches of the original: not counted: the program is written with REAL by hand, and has no original
*/
#include <stdio.h>
#ifdef ONLY_GCC
__asm__(".psize 60");
#endif
static double f(double x) {
  return x > 90 ? x : x + 1;
}
int main(int argc, char **argv) {
  double x = 0.5, y = 0;
  int mode = 2;
  if (argc > 5) return 1;
  for (int round = 0; round < 2; ++round) {
    if (round == 1) {
#pragma symreal input(x) range(0, 1)
      switch (mode) {
      case 1: y = x; break;
      default: y = 2 * x;
      }
      for (int k = 0; k < 3; ++k) y += f(k);
      if (mode == 2 && x < 0.25)
        y += 1;
#pragma symreal output(y) generate("block.c")
      if (y > 50) return 2;
    }
  }
  printf("%g\n", y);
  return 0;
}
