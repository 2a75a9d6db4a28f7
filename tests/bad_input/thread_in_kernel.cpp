// A kernel is recorded by one thread. A thread that it starts, and joins, does not record: that is what is said, not that
// the value were used outside of the kernel.
// RUN: not %symreal generate %s -o %t.c -- -pthread 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdio>
#include <thread>

#pragma symreal function input(x[0:2]) output(y[0:2])
void f(double const *x, double *y) {
  // CHECK: thread_in_kernel.cpp:[[@LINE+1]]:{{[0-9]+}}: error: a value of a kernel is used in a thread that does not record it: a kernel is recorded by the thread that began it [SYM054]
  std::thread other([&] { y[0] = x[0] * 2; });
  other.join();
  y[1] = x[1];
}

int main() {
  double x[2] = {1, 2}, y[2];
  f(x, y);
  std::printf("%g %g\n", y[0], y[1]);
}
