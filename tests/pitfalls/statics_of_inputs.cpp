// A static variable that the first call initialises from inputs keeps its value in every later call, whatever holds the
// numbers: generated code would compute it anew.
// RUN: not %symreal generate %s -o %t/ 2>&1 | FileCheck %s
// RUN: not ls %t
// What depends on no input is initialised once and for all.
// RUN: %symreal generate %s -o %t.c -- -DCONSTANT && %symreal verify %s %t.c --samples=100 -- -DCONSTANT
// verify sees it by itself: calls in a row have different inputs.
// RUN: %symreal generate %s -o %t.c -- -DLATER && not %symreal verify %s %t.c --samples=100 -- -DLATER 2>&1 | FileCheck %s --check-prefix=LATER
// LATER: error: called again, 1 of 1 outputs differ from the original: it keeps something other than its outputs
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#ifdef CONSTANT
static std::vector<double> const &table() {
  static std::vector<double> const numbers = [] {
    std::vector<double> result;
    for (int i = 0; i < 5; ++i) result.push_back(std::sqrt(2.0 + i));
    return result;
  }();
  return numbers;
}
static double shared = 2.5;
#pragma symreal function input(x) constant(shared) output(return)
double constants(double x) {
  static double const &reference = shared;
  static std::unique_ptr<double> const owned(new double(1.5));
  static int const count = static_cast<int>(table().size());
  static std::vector<double> const &kept = std::vector<double>{1, 2};
  return x * table()[2] * reference * *owned * count * kept[1];
}
int main() { std::printf("%g\n", constants(0.5)); }

#elif defined(LATER)
#ifdef MBD_SYMBOLIC
#define KEPT
#else
#define KEPT static
#endif
#pragma symreal function input(x) output(return)
double later(double x) {
  KEPT double const first = x * 2;
  return first + x;
}
int main() { std::printf("%g\n", later(0.5)); }

#else
// CHECK-DAG: error: the first call initialises static 'number(double)::first' from its inputs, and later calls keep this value [SYM214]
#pragma symreal function input(x) output(return)
double number(double x) {
  static double const first = x * 2;
  return first * x;
}
// CHECK-DAG: error: the first call initialises static 'ofThread(double)::first' from its inputs
#pragma symreal function input(x) output(return)
double ofThread(double x) {
  static thread_local double const first = x * 2;
  return first * x;
}
// CHECK-DAG: error: the first call initialises static 'container(double)::first' from its inputs
#pragma symreal function input(x) output(return)
double container(double x) {
  static std::vector<double> const first{1, x};
  return first[1] * x;
}
// CHECK-DAG: error: the first call initialises static 'tree(double)::first' from its inputs
#pragma symreal function input(x) output(return)
double tree(double x) {
  static std::map<int, std::vector<double>> const first{{1, {x, 2}}};
  return first.at(1)[0] * x;
}
// CHECK-DAG: error: the first call initialises static 'pointer(double)::first' from its inputs
#pragma symreal function input(x) output(return)
double pointer(double x) {
  static std::shared_ptr<double> const first = std::make_shared<double>(x);
  return *first * x;
}
// CHECK-DAG: error: the first call initialises static 'table(double)::first' from its inputs
#pragma symreal function input(x) output(return)
double table(double x) {
  static double const *const first = [&] {
    auto *numbers = new double[2];
    numbers[1] = x;
    return numbers;
  }();
  return first[1] * x;
}
// CHECK-DAG: error: the first call initialises static 'reference(double const*)::first' from its inputs
#pragma symreal function input(x[0:2]) output(return)
double reference(double const *x) {
  static double const &first = x[1];
  return first * x[0];
}
// CHECK-DAG: error: the first call initialises static 'helper(double)::first' from its inputs
static double helper(double x) {
  struct Pair {
    double a, b;
  };
  static Pair const first{1, x};
  return first.b;
}
#pragma symreal function input(x) output(return)
double helped(double x) { return helper(x) * x; }
// CHECK-DAG: error: the first call initialises static 'captured(double)::first' from its inputs
#pragma symreal function input(x) output(return)
double captured(double x) {
  static std::function<double(double)> const first = [x](double y) { return x * y; };
  return first(x);
}
// CHECK-DAG: error: the first call initialises static 'temporary(double)::first' from its inputs
#pragma symreal function input(x) output(return)
double temporary(double x) {
  static double const &first = x * 2;
  return first * x;
}

int main() {
  double const x[2] = {0.5, 1.5};
  std::printf("%g\n", number(0.5) + ofThread(0.5) + container(0.5) + tree(0.5) + pointer(0.5) + table(0.5) +
                          reference(x) + helped(0.5) + captured(0.5) + temporary(0.5));
}
#endif
