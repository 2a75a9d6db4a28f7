// An integer that was made of a number and is then worked on bit by bit: by decisions, which guards record.
// RUN: %same %s
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: %symreal generate %s --decisions=guard -o %t.c && %symreal verify %s %t.c --samples=200 --min-samples=20
#include <cmath>
#include <cstdio>

#pragma symreal function input(x) range(0, 4) output(return)
double kernel(double x) {
  unsigned long long cell = (unsigned long long)std::floor(x);
  // CHECK: bits_of_integers.cpp:[[@LINE+1]]:{{.*}}error: the program decides on a symbolic value: the conversion of
  cell <<= 2;
  cell |= 1;
  cell ^= 3;
  cell >>= 1;
  cell &= 0xFF;
  return x + double(cell);
}

int main() { std::printf("%g\n", kernel(2.5)); }
