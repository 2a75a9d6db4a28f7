// Bytes of a REAL that a library looks at, in a template, where no run can tell.
// RUN: not %symreal generate %s -o %t.c -- -std=c++20 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <atomic>
#include <cstdio>
#include <span>

// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are used as another type [SYM035]
template <class T> int last(T x) { return int(std::as_bytes(std::span(&x, 1))[7]); }
struct Pair {
  double a, b;
};
// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of an object that holds REALs are compared [SYM035]
bool swap_in(std::atomic<Pair> &p, Pair &old, Pair now) { return p.compare_exchange_strong(old, now); }
// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are compared [SYM035]
bool swap_raw(double *p, double *old, double *now) { return __atomic_compare_exchange(p, old, now, false, 5, 5); }

int main() {
  double x = 1.5, y;
#pragma symreal input(x)
  y = x + last(x);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
