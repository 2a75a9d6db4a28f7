// A conversion to an integer of fewer bits keeps the low ones; that of a number beyond its type is what the host makes
// of it. A decision is on the value that the type holds.
// RUN: rm -rf %t && mkdir %t
// RUN: %same %s
// RUN: %symreal generate %s --decisions=guard --mainline -o %t/k.c
// RUN: %symreal verify %s %t/k.c --samples=500 --min-samples=20
// RUN: %cxx -w %s -o %t/original && %symreal-c++ -w %s -o %t/symbolic
// RUN: %t/original > %t/expected && env SYMREAL_REQUEST=decisions=guard %t/symbolic | tail -n 9 | diff %t/expected -
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror %t/k.c %t/k_main.c -lm -o %t/run
// RUN: %t/run | diff %t/expected -
// RUN: FileCheck %s < %t/expected
#include <cstdint>
#include <cstdio>

#pragma symreal function input(p) range(5.3, 5.305) input(q) range(0, 10) output(y[0:9])
void k(double p, double q, double *y) {
  uint16_t a = (uint16_t)(p * 10000);
  a += 30000;
  y[0] = a; // CHECK: y[0] = 17464
  short s = (int)p * 9000;
  y[1] = s; // CHECK: y[1] = -20536
  y[2] = (short)(p * 10000); // CHECK: y[2] = -12536
  y[3] = (unsigned char)(p * 50); // CHECK: y[3] = 9
  y[4] = (int)(unsigned)(-q); // CHECK: y[4] = -2
  // Fixed point: the product of two numbers of 16 bits, without its lowest.
  uint16_t f = (uint16_t)(p * 4096), g = (uint16_t)(q * 4096);
  y[5] = (uint16_t)((uint32_t)f * g >> 12); // CHECK: y[5] =
  s++;
  y[6] = s;
  // The index of a switch is what is left of the number.
  switch ((unsigned char)((int)(p * 100))) {
  case 18: y[7] = 1; break; // 530
  default: y[7] = 2;
  }
  // CHECK: y[7] = 1
  int n = 0;
  for (uint16_t i = (uint16_t)((int)p * 13108); i > 0; i--) ++n;
  y[8] = n; // 65540 // CHECK: y[8] = 4
}

int main() {
  double y[9];
  k(5.3, 2.7, y);
  for (int i = 0; i < 9; ++i) printf("y[%d] = %.17g\n", i, y[i]);
}
