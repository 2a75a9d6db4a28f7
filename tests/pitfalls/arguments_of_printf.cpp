// Numbers and truth values that go through `...` arrive as what they are in the original.
// RUN: %same %s
// RUN: cd %S && %rewrite arguments_of_printf.cpp | FileCheck arguments_of_printf.cpp
// RUN: %symreal generate %s -o %t.c --run-on 2>&1 | FileCheck %s --check-prefix=PRINTED --implicit-check-not=error
#include <cmath>
#include <cstdarg>
#include <cstdio>

void log(char const *format, ...) {
  va_list list;
  va_start(list, format);
  std::vprintf(format, list);
  va_end(list);
}

template <class T> void show(char const *name, T x) { std::printf("%s %g|", name, x); }

int main() {
  double x = 0.5, y = 2.0, z;
#pragma symreal input(x, y)
  // CHECK: std::printf("%g %g %d|", REAL_VALUE(x), 1.5, 3);
  std::printf("%g %g %d|", x, 1.5, 3);
  // CHECK: std::printf("%d %d %d|", REAL_VALUE(x < y), REAL_VALUE(!(x > y)), REAL_VALUE(std::isnan(x)));
  std::printf("%d %d %d|", x < y, !(x > y), std::isnan(x));
  auto const below = x < y;
  // CHECK: std::printf("%d|", REAL_VALUE(below));
  std::printf("%d|", below);
  // CHECK: log("%g %s|", REAL_VALUE(x), "text");
  log("%g %s|", x, "text");
  show("in a template", x);
  z = x + y;
#pragma symreal output(z) generate("z.c")
  std::printf("%g\n", z);
}
// PRINTED: 0.5 1.5 3|1 1 0|1|0.5 text|in a template 0.5|2.5
