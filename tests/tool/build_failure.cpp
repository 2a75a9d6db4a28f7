// What compiles with double and not with REAL is reported where it stands in the source, by line and column.
// RUN: rm -rf %t && mkdir %t
// RUN: not %symreal generate %s -o %t/a.c 2>&1 | FileCheck %s
// CHECK: build_failure.cpp:[[#@LINE+7]]:{{[0-9]+}}: error: the program does not compile in symbolic mode: {{.*}}[SYM005]
// RUN: ls -A %t | count 0
#include <type_traits>

int main() {
  double x = 1;
#pragma symreal input(x)
  static_assert(std::is_floating_point<decltype(x)>::value, "numbers only");
#pragma symreal output(x) generate("x.c")
}
