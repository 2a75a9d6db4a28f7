// Integers that the kernel changes and that outlive it: generated code would not change them.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c > %t.log 2>&1 && FileCheck %s < %t.log && not grep -E "'(i|phase)'" %t.log
// RUN: not ls %t.c

#include <cstdio>

static int calls = 0;

class Filter {
public:
  double sum_ = 0;
  double step(double x) {
    for (i_ = 0; i_ < 3; i_++) sum_ += x;
    started_ = true;
    return sum_;
  }

private:
  int i_;
  bool started_ = true;
};

double step(Filter &filter, double x) {
  static int i, phase; // i is written before it is read, and nobody else can read it
  for (i = 0; i < 2; i++) x += 1;
  switch (phase) {
  case 0: phase = 1; return x;
  default: return filter.step(x);
  }
}

#pragma symreal function input(x) scratch(filter.sum_) constant(filter.sum_) output(return) call(2)
double run(Filter &filter, double x, int *status) {
  calls++;
  *status = 0;
  return step(filter, x);
}

int main() {
  int status = 5;
  Filter filter;
  std::printf("%g\n", run(filter, 0.5, &status) + run(filter, 0.5, &status));
}

// CHECK-DAG: kept_integers.cpp:8:12: error: the kernel writes 'calls', which is not an output [SYM053]
// CHECK-DAG: kept_integers.cpp:14:10: error: the kernel writes 'i_', which is not an output [SYM053]
// CHECK-DAG: kept_integers.cpp:15:5: error: the kernel writes 'started_', which is not an output [SYM053]
// CHECK-DAG: kept_integers.cpp:36:3: error: the kernel writes '*status', which is not an output [SYM053]
// CHECK: help:
