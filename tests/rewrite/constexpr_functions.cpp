// A constexpr function of numbers becomes one of REAL; constants that it computes stay double.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// RUN: FileCheck %s --check-prefix=TEXT < %t.c
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
// TEXT: double const y = input[0]*1.8*2.5 + 3.0 + 3.0;
#include <cstdio>

// CHECK: static constexpr REAL fahrenheit(REAL kelvin) { return kelvin * 1.8; }
static constexpr double fahrenheit(double kelvin) { return kelvin * 1.8; }
// CHECK: constexpr double scale = REAL_VALUE(4.5 / fahrenheit(1.0));
constexpr double scale = 4.5 / fahrenheit(1.0);
struct Constants {
  // CHECK: static constexpr double list[2] = {REAL_VALUE(fahrenheit(5.0)), 1.0};
  static constexpr double list[2] = {fahrenheit(5.0), 1.0};
  // CHECK: static constexpr int whole = REAL_VALUE(fahrenheit(10.0) / 6);
  static constexpr int whole = fahrenheit(10.0) / 6;
};
static_assert(fahrenheit(10.0) == 18.0);
char buffer[static_cast<int>(fahrenheit(10.0))];

int main() {
  double x = 3;
#pragma symreal input(x)
  double y = fahrenheit(x) * scale + Constants::whole + Constants::list[0] / 3;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
