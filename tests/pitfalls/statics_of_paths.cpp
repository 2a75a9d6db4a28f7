// A static variable may depend on inputs by a decision alone: its value is an ordinary one, which later calls keep.
// RUN: not %symreal generate %s -o %t/ --decisions=guard 2>&1 | FileCheck %s
// RUN: not ls %t
// A decision on constants, or beside the initialiser, is right.
// RUN: %symreal generate %s -o %t.c --decisions=guard -- -DBESIDE && %symreal verify %s %t.c --samples=50 --min-samples=10 -- -DBESIDE
#include <cstdio>
#include <vector>

static double const table[4] = {1, 2, 3, 4};

#ifdef BESIDE
static double chosen(double x) {
  static std::vector<double> const numbers = table[1] > 1 ? std::vector<double>{1, 2} : std::vector<double>();
  return x > 0 ? numbers[0] : numbers[1];
}
#pragma symreal function input(x) output(return)
double beside(double x) {
  double const first = chosen(x);
  static double const *const last = table + 3;
  return first * *last * x;
}
int main() { std::printf("%g\n", beside(0.5)); }

#else
// CHECK-DAG: error: the first call initialises static 'truth(double)::positive' from its inputs, and later calls keep this value [SYM214]
#pragma symreal function input(x) output(return)
double truth(double x) {
  static bool const positive = x > 0;
  return positive ? x * 2 : x - 1;
}
// CHECK-DAG: error: the first call initialises static 'converted(double)::whole' from its inputs
#pragma symreal function input(x) output(return)
double converted(double x) {
  static int const whole = static_cast<int>(x);
  return whole * x;
}
// CHECK-DAG: error: the first call initialises static 'pointer(double)::part' from its inputs
#pragma symreal function input(x) output(return)
double pointer(double x) {
  static double const *const part = x > 0 ? table : table + 2;
  return *part * x;
}
// CHECK-DAG: error: the first call initialises static 'called(double)::list' from its inputs
static std::vector<double> made(double x) {
  if (x < 1) return {1, 2};
  return {2, 3};
}
#pragma symreal function input(x) output(return)
double called(double x) {
  static std::vector<double> const list = made(x);
  return list[1] * x;
}
int main() { std::printf("%g\n", truth(0.5) + converted(0.5) + pointer(0.5) + called(0.5)); }
#endif
