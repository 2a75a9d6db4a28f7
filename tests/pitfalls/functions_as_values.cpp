// Functions as values: of the program, of the library, lambdas, objects.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=200
// RUN: FileCheck %s --input-file=%t.c
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

typedef double (*Function)(double);
struct Table {
  Function first;
  double (*second)(double, double);
};

static double twice(double x) { return 2.0 * x; }
static double apply(double (*f)(double), double x) { return f(x); }

// CHECK-DAG: sin(input[0])
// CHECK-DAG: cos(input[0])
// CHECK-DAG: atan2(
#pragma symreal function input(x, y) range(0.1, 2) output(return)
double sum(double x, double y) {
  Table const table = {sin, std::atan2};
  Function const plain = twice;
  std::function<double(double)> const wrapped = [y](double t) { return t * y; };
  double values[2] = {x, y};
  double (*square_root)(double) = &std::sqrt;
  std::transform(values, values + 2, values, square_root);
  return table.first(x) + table.second(y, x) + plain(x) + apply(cos, x) + wrapped(x) + values[1];
}

int main() { std::printf("%g\n", sum(0.5, 0.25)); }
