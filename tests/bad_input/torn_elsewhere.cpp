// A part of a symbolic number is overwritten by code that was not rewritten: reported where the number is used next.
// RUN: not %symreal generate %s -o %t.low.c -- -DSIZE=4 2>&1 | FileCheck %s
// RUN: not %symreal generate %s -o %t.byte.c -- -DSIZE=1 2>&1 | FileCheck %s
// RUN: not ls %t.low.c %t.byte.c
// CHECK: torn_elsewhere.cpp:[[@LINE+20]]:{{[0-9]+}}: error: a number is used of which a part was overwritten; the rest is that of a symbolic value [SYM199]
#include <cstdio>
#include <cstring>

struct Cell {
  double value;
};

// The address is an integer on its way: the source does not show that numbers lie there.
static void clear(unsigned long address) {
  void *(*volatile fill)(void *, int, std::size_t) = std::memset;
  fill(reinterpret_cast<void *>(address), 0, SIZE);
}

int main() {
  double x = 0.5, y;
#pragma symreal input(x)
  Cell cell = {x * 3.0};
  for (int k = 0; k < 300; ++k) cell.value += x;
  clear(reinterpret_cast<unsigned long>(&cell));
  y = 2.0 * cell.value;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
