/* Functions of a compiled library, called from a C source: arrays of several sizes, an array that is read and written,
   structs, an integer result; what is pure is called once, what is not as often and in the order of the original.
   RUN: rm -rf %t && mkdir %t
   RUN: split-file %S/Inputs/external.txt %t
   RUN: %cc -std=c99 -O1 -c %t/library.c -o %t/library.o && ar rcs %t/libexternal.a %t/library.o
   RUN: cp %s %t/main.c
   RUN: %symreal generate %t/main.c -o %t/k.c --mainline --graph %t/k.graph --link "-L%t -lexternal"
   RUN: FileCheck %s --input-file=%t/k.c
   RUN: FileCheck %s --check-prefix=GRAPH --input-file=%t/k.graph
   RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -O1 -ffp-contract=off %t/k.c %t/k_main.c -L%t -lexternal -lm -o %t/run
   RUN: %cc -w %t/main.c -L%t -lexternal -lm -o %t/original
   RUN: %t/run | sed 's/.*= //' > %t/generated.txt
   RUN: %t/original | diff - %t/generated.txt
   RUN: %symreal verify %t/main.c %t/k.c --link "-L%t -lexternal" --samples=100 2>&1 | FileCheck %s --check-prefix=PROOF
   RUN: %symreal verify %t/main.c %t/k.c --link "-L%t -lexternal" --samples=100 --exact 256 2>&1 | FileCheck %s --check-prefix=EXACT
   EXACT: exact values, in 256 bits: there are none: it calls functions of the program

   A change in what is called is found.
   RUN: sed 's/counted(\(.*\), \(.*\))/counted(\1 + 1, \2)/' %t/k.c > %t/changed.c
   RUN: cp %t/k.h %t/changed.h
   RUN: not %symreal verify %t/main.c %t/changed.c --link "-L%t -lexternal" --samples=100

   CHECK: struct numbers_2 {
   CHECK: double counted(int, double const *);
   CHECK-NOT: double counted(
   CHECK: void preprocess(
   CHECK: gain(parameters[0])
   CHECK: void compute(
   CHECK: rotate(
   CHECK-NOT: rotate(
   CHECK: = counted(2, a
   CHECK: = counted(3, a
   GRAPH: external 0 "gain" pure returns number takes number at
   GRAPH: effect %
   PROOF: 100 samples, 1{{00| 00}}
   PROOF-NOT: error */
#include "library.h"
#include <stdio.h>
#pragma symreal external(gain) pure
#pragma symreal external(rotate) pure input(vector[0:3]) output(vector)
#pragma symreal external(counted) input(x[0:n])

int main(void) {
  double x[3] = {0.5, -0.25, 2.0}, p = 3.0, y[3], first, second;
  struct pair turned, again;
#pragma symreal input(x[0:3]) range(-2, 2) parameter(p)
  y[0] = x[0], y[1] = x[1], y[2] = x[2];
  turned = rotate(gain(p) * x[0], y);
  y[0] = x[0], y[1] = x[1], y[2] = x[2];
  again = rotate(gain(p) * x[0], y);
  first = counted(2, y);
  second = counted(3, y) * turned.a + again.b;
#pragma symreal output(y[0:3], first, second) generate("k.c")
  printf("%.17g\n%.17g\n%.17g\n%.17g\n%.17g\n", y[0], y[1], y[2], first, second);
  return 0;
}
