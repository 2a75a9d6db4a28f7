// A static variable of a function belongs to the first call as that has initialised it, also where a decision did; what
// is changed in it later is state like any other.
// RUN: rm -rf %t && not %symreal generate %s --decisions=guard -o %t/ 2>&1 | FileCheck %s
// RUN: not ls %t
// RUN: %symreal generate %s -o %t.c -- -DSCRATCH && %symreal verify %s %t.c --samples=50 -- -DSCRATCH
// RUN: not %symreal generate %s --kernel 'kept(x[0:2]={1, 2}) -> return' -o %t.c -- -DKEPT 2>&1 | FileCheck %s --check-prefix=KEPT
// KEPT: error: the first call initialises static 'kept(double const*)::first' from its inputs, and later calls keep this value [SYM214]
#include <cstdio>
#include <random>
#include <vector>

#if defined(KEPT)
// Its argument is whatever the caller has.
double kept(double const *x) {
  static double const *const first = x;
  return first[1] * x[0];
}

#elif defined(SCRATCH)
#pragma symreal function input(x) scratch(file) output(return)
double scratch(double x) {
  static double work[3];
  static std::vector<double> list(2);
  work[1] = x * 2;
  list[1] = work[1] + x;
  return list[1] * x;
}
int main() { std::printf("%g\n", scratch(0.5)); }

#else
// CHECK-DAG: error: the first call initialises static 'chosen(double)::first' from its inputs, and later calls keep this value [SYM214]
#pragma symreal function input(x) output(return)
double chosen(double x) {
  static double const first = x > 0 ? 2.0 : 5.0;
  return first * x;
}
// CHECK-DAG: error: the first call initialises static 'converted(double)::first' from its inputs,
#pragma symreal function input(x) output(return)
double converted(double x) {
  static int const first = static_cast<int>(3 * x);
  return first * x;
}
// CHECK-DAG: error: the first call initialises static 'decided(double)::function' from its inputs,
static double half(double x) { return x / 2; }
static double twice(double x) { return x * 2; }
#pragma symreal function input(x) output(return)
double decided(double x) {
  static double (*const function)(double) = x > 0 ? half : twice;
  return function(x);
}
// CHECK-DAG: :[[@LINE+3]]:17: error: the kernel writes 'work', which is not an output [SYM053]
#pragma symreal function input(x) output(return)
double written(double x) {
  static double work[3];
  work[1] = x * 2;
  return work[1] * x;
}
// CHECK-DAG: error: the kernel changes {{.*}} of 'drawn(double)::generator' (static, {{.*}}), which is not an output [SYM053]
#pragma symreal function input(x) output(return)
double drawn(double x) {
  static std::mt19937 generator(3);
  std::uniform_real_distribution<double> number;
  return x * number(generator);
}
// CHECK-DAG: error: the kernel changes {{.*}} a block of 12 bytes on the heap, which is not an output [SYM053]
#pragma symreal function input(x) output(return)
double counted(double x) {
  static std::vector<int> counts(3);
  return x * ++counts.at(1);
}
int main() {
  std::printf("%g\n", chosen(0.5) + converted(0.5) + decided(0.5) + written(0.5) + drawn(0.5) + counted(0.5));
}
#endif
