// An exchange on comparison compares numbers, and is a decision; additions of atomics are recorded.
// RUN: %same %s -- -std=c++20
// RUN: grep -v "pragma symreal" %s > %t.plain.cpp
// RUN: %cxx -std=c++20 %t.plain.cpp -o %t.orig && %symreal-c++ -std=c++20 %t.plain.cpp -o %t.exe
// RUN: %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: %symreal generate %s -o %t.c -- -std=c++20 && %symreal verify %s %t.c --min-samples=20 --samples=100 -- -std=c++20
// RUN: FileCheck %s --input-file=%t.c
// RUN: sed s/guard/error/ %s > %t.cpp && not %symreal generate %t.cpp -o %t.c -- -std=c++20 2>&1 | FileCheck %s --check-prefix=ERROR
#include <atomic>
#include <cstdio>

// CHECK: int compute(
// CHECK: if (input[1] == input[0] - 3.0) return 1;
#pragma symreal function input(x[0:2]) output(y[0:5]) decisions(guard)
void compute(double const *x, double *y) {
  std::atomic<double> a{x[0] + 1.0};
  double expected = 1.0 + x[0] * 1.0;
  // ERROR: [[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value
  bool const done = a.compare_exchange_strong(expected, x[1]);
  y[0] = a.load() + (done ? 100.0 : 0.0);
  double z = x[1], other = x[0] - 3.0;
  std::atomic_ref<double> r(z);
  y[1] = r.compare_exchange_strong(other, 7.0) ? 50.0 * x[0] : 60.0 * x[0];
  y[2] = z + other;
  std::atomic<double> sum = 0.0;
  sum += x[0];
  y[3] = sum.fetch_add(x[1]) + 2.0 * sum;
  double old = sum;
  while (!sum.compare_exchange_weak(old, old * x[1])) {}
  y[4] = sum.exchange(3.0) - sum;
}

int main() {
  double x[2] = {5.25, 2.0}, y[5];
  compute(x, y);
  for (double each : y) std::printf("%.17g\n", each);
}
