// Containers, classes and what a class has baked in; what is called through a pointer is part of the recording.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o k.c --wrapper --decisions=guard -- -DKERNEL=1
// DEFINE: %{c} = %cxx -Wall -Wextra -Wno-unknown-pragmas
// RUN: cd %t && %cc -c k.c && %{c} k_wrapper.cpp k.o -o swapped && ./swapped > printed && %{c} %s -o original && ./original | diff - printed
// RUN: cd %t && %symreal verify %s k.c --samples=50 --min-samples=5 -- -DKERNEL=1 2>&1 | FileCheck %s
// CHECK: the wrapper was tried as well

// RUN: cd %t && not %symreal generate %s -o l.c --wrapper -- -DKERNEL=2 2>&1 | FileCheck %s --check-prefix=POINTER
// POINTER: error: --wrapper cannot compare 'law' of 'controlled', which is baked in: a function that is called through it is part of the recording [SYM095]
// RUN: cd %t && not %symreal generate %s -o l.c --wrapper --frozen=allow -- -DKERNEL=3 2>&1 | FileCheck %s --check-prefix=FROZEN
// FROZEN: error: --wrapper cannot compare 'load', which is baked in and may be another in the next call: name it in input, parameter or constant [SYM095]
// RUN: ls %t | not grep l_wrapper
#include <cstdio>
#include <string>
#include <vector>

#ifndef KERNEL
#define KERNEL 0
#endif

static double load = 2;

class Filter {
public:
  explicit Filter(int order) : order_(order), table_(order, 0.5) {}
  void set(int k, double value) { table_[k] = value; }
#if KERNEL == 1
#pragma symreal function input(x) constant(order_, table_, index) output(return)
#endif
  double step(double x, std::vector<int> const &index, std::string const &name) const {
    double sum = x > 0 ? 0 : 1;
    for (int k = 0; k < order_; ++k) sum += x * table_[k] * index[k];
    return name == "inverse" ? -sum : sum;
  }

private:
  int order_;
  std::vector<double> table_;
};

#if KERNEL == 2
#pragma symreal function input(x) output(return)
#endif
double controlled(double x, double (*law)(double)) { return law(x) + x; }

#if KERNEL == 3
#pragma symreal function input(x) output(return)
#endif
double loaded(double x) { return x * load; }

static double twice(double x) { return 2 * x; }

int main() {
  Filter two(2), three(3);
  std::vector<int> index = {1, 2, 3};
  std::printf("%g\n", two.step(1.5, index, "plain"));
  std::printf("%g %g\n", two.step(-1.5, index, "plain"), two.step(1.5, index, "inverse"));
  std::printf("%g\n", three.step(1.5, index, "plain"));
  index[1] = 4;
  std::printf("%g\n", two.step(1.5, index, "plain"));
  index[1] = 2;
  two.set(1, 0.75);
  std::printf("%g\n", two.step(1.5, index, "plain"));
  std::printf("%g\n", controlled(1.5, twice));
  load = 3;
  std::printf("%g\n", loaded(1.5));
}
