// An integer that was made of a number and is then worked on bit by bit: shifts and masks are recorded like arithmetic.
// RUN: %same %s
// RUN: rm -f %t.c
// RUN: %symreal generate %s -o %t.c && FileCheck %s --input-file=%t.c
// RUN: %symreal verify %s %t.c --samples=500
#include <cmath>
#include <cstdio>

#pragma symreal function input(x) range(0, 1000) output(y[0:4])
void kernel(double x, double *y) {
  unsigned long long cell = (unsigned long long)std::floor(x);
  // CHECK: wide_shl(
  cell <<= 2;
  cell |= 1;
  cell ^= 3;
  cell >>= 1;
  cell &= 0xFF;
  y[0] = x + double(cell);
  int i = (int)x - 500;
  y[1] = (i >> 3) + (i & 7) + (~i | 4);
  // Gray code, and the bits of a number in the other order.
  unsigned g = (unsigned)x ^ (unsigned)x >> 1;
  y[2] = g;
  unsigned r = (unsigned)x;
  r = (r >> 1 & 0x55555555) | (r & 0x55555555) << 1;
  r = (r >> 2 & 0x33333333) | (r & 0x33333333) << 2;
  r = (r >> 4 & 0x0F0F0F0F) | (r & 0x0F0F0F0F) << 4;
  y[3] = r << 24 | (r & 0xFF00) << 8 | (r >> 8 & 0xFF00) | r >> 24;
}

int main() {
  double y[4];
  kernel(2.5, y);
  std::printf("%g %g %g %g\n", y[0], y[1], y[2], y[3]);
}
