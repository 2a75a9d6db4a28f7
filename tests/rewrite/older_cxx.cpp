// Before C++20, u8"text" is of plain characters and char8_t a name like others; the symbolic program is C++20.
// RUN: %symreal generate %s -o %t.c -- -std=c++17 && FileCheck %s < %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c -- -std=c++17
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c
// RUN: env SYMREAL_ROOTS=%S %symreal-c++ -std=c++17 -c %s -o %t.o
// RUN: not %symreal generate %s -o %t.c -- -std=c++20 2>&1 | FileCheck %s --check-prefix=NEWER
// CHECK: input[0]*3.0
// NEWER: error
#include <cstdio>

static char const *const unit = u8"\u00b5m";

int main() {
  int char8_t = 3;
  double x = 0.5, y;
#pragma symreal input(x)
  y = char8_t * x;
#pragma symreal output(y) generate("y.c")
  std::printf("%g %s\n", y, unit);
}
