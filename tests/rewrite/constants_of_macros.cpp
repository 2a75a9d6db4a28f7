// A macro's text is converted for all of its uses, and some are constants that stay double.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify --samples=100 --min-samples=10 %s %t.c
#include <cstdio>
#include <limits>
#define NUMBER double
#define EPSILON ((std::numeric_limits<NUMBER>::epsilon)())
typedef NUMBER Number;

struct Generator {
  static const long double largest;
};
// CHECK: const long double Generator::largest = REAL_TO(long double, 1.0 - EPSILON);
const long double Generator::largest = 1.0 - EPSILON;

static bool is_close(Number x, Number y) {
  // CHECK: constexpr double tolerance = REAL_VALUE(42 * EPSILON);
  constexpr double tolerance = 42 * EPSILON;
  return x - y < tolerance;
}
static Number smallest() { return EPSILON; }

int main() {
  double x = 0.5, y;
#pragma symreal input(x)
  y = is_close(x, 1 - x) ? x + smallest() : static_cast<double>(Generator::largest) * x;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
