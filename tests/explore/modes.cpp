// With NaN no two numbers stand in an order. Mode strict takes them into account: not (x < y) says nothing of x >= y there.
// In finite and fast it does, and there are fewer paths.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/finite.c --decisions=explore --explore=joins=off 2>&1 | FileCheck %s --check-prefix=THREE
// RUN: %symreal generate %s -o %t/strict.c --fp=strict --decisions=explore --explore=joins=off 2>&1 | FileCheck %s --check-prefix=STRICT
// RUN: %symreal generate %s -o %t/fast.c --fp=fast --decisions=explore --explore=joins=off 2>&1 | FileCheck %s --check-prefix=THREE
// THREE: explored 3 paths
// STRICT: explored 4 paths
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/finite.c > %t/verified 2>&1
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/strict.c >> %t/verified 2>&1
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/fast.c >> %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SAME < %t/verified
// SAME: kernel order, mode finite
// SAME: no sample is left to a guard
// SAME: value_return 1 0 0{{$}}
// SAME: kernel order, mode strict
// SAME: no sample is left to a guard
// SAME: value_return 1 0 0{{$}}
// SAME: kernel order, mode fast
// SAME: value_return 1 0 0{{$}}
#include <cstdio>

#pragma symreal function input(x, y) output(return)
double order(double x, double y) {
  double result = 1;
  if (x < y) result = x;
  if (x >= y) result += 2 * y;
  if (y == x) result *= 3;
  return result;
}

int main() {
  std::printf("%g\n", order(1, 2));
}
