// Each kernel of a program is explored in runs of its own: a block, which is met again and again, one that decides nothing, one
// that decides on parameters, and one that begins where another has decided.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=explore --explore=joins=off 2> %t/table
// RUN: FileCheck %s < %t/table
// CHECK-NOT: warning
// CHECK: kernel plain:
// CHECK-NOT: explored
// CHECK: kernel limited:
// CHECK: explored 4 paths, 3 selects between them; complete: no guards
// CHECK: kernel block:
// CHECK: explored 4 paths, 2 selects between them; complete: no guards
// RUN: FileCheck %s --check-prefix=LIMITED < %t/limited.c
// LIMITED: void preprocess(
// LIMITED: constants[3] = 
// RUN: %symreal verify --samples=100 --min-samples=10 %s plain.c limited.c block.c > %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SAME < %t/verified
// SAME: kernel plain, mode finite
// SAME: value_return 1 0 0{{$}}
// SAME: kernel limited, mode finite
// SAME: no sample is left to a guard
// SAME: value_return 1 0 0{{$}}
// SAME: kernel block, mode finite
// SAME: no sample is left to a guard
// SAME: y[0] 2 0 0{{$}}
#include <cstdio>
#include <utility>

#pragma symreal function input(x) output(return)
double plain(double x) {
  return 2 * x + 1;
}

#pragma symreal function input(x) parameter(low, high) output(return)
double limited(double x, double low, double high) {
  if (low > high) std::swap(low, high);
  int const where = low * low > high ? 1 : 2;
  return x * low + high * where;
}

int main() {
  double sum = plain(1);
  for (int k = 0; k < 3; ++k) {
    double x[2] = {0.5 - k, 0.25}, y[2];
#pragma symreal input(x)
    for (int i = 0; i < 2; ++i) {
      double *to = x[i] > 0 ? &y[i] : &y[1 - i];
      y[0] = y[1] = x[1];
      *to = 2 * x[i];
    }
#pragma symreal output(y) generate("block.c")
    sum += y[0] + limited(x[1], 1, 2);
  }
  std::printf("%g\n", sum);
}
