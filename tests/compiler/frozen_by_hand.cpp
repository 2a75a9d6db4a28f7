// A program of the drop-in compiler that is run by hand says what it would bake in, as the driver does.
// RUN: rm -rf %t && mkdir %t && cd %t && env SYMREAL_ROOTS=%S %symreal-c++ %s -o weigh
// RUN: cd %t && not ./weigh 2>&1 | FileCheck %s --check-prefix=ERROR
// ERROR: frozen_by_hand.cpp:13:{{[0-9]+}}: error: kernel 'weight' reads 'gravity' (9.81), which is neither input nor parameter [SYM017]
// RUN: not ls %t/weight.c
// RUN: cd %t && env SYMREAL_REQUEST=frozen=warn ./weigh 2>&1 | FileCheck %s --check-prefix=WARNING
// WARNING: warning: kernel 'weight' reads 'gravity' (9.81)
// RUN: FileCheck %s --check-prefix=HEADER < %t/weight.h
// RUN: rm %t/weight.c && cd %t && env SYMREAL_REQUEST=frozen=allow ./weigh 2>&1 | FileCheck %s --check-prefix=ALLOWED --implicit-check-not=SYM017
// RUN: ls %t/weight.c
#include <cstdio>

double gravity = 9.81;

int main() {
  double mass = 2, weight;
#pragma symreal input(mass)
  weight = mass * gravity;
#pragma symreal output(weight) generate("weight.c")
  std::printf("%g\n", weight);
}
// ALLOWED: 19.62
// HEADER: Baked in with the values that the program had there when this was recorded:
// HEADER-NEXT: gravity = 9.81 (frozen_by_hand.cpp:13:8)
