// A sample on which the original crashes costs that sample its process, not the tool.
// RUN: %symreal generate %s -o %t.c
// RUN: not %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
// CHECK: verify_crash.cpp:12:{{[0-9]+}}: error: signal {{[0-9]+}} {{.*}} ended the original's kernel on a sample [SYM093]
#include <cmath>
#include <cstdlib>

extern "C" char const *symreal_requested(char const *); // runtime/wire/request.h

int main() {
  double x = 0.5;
#pragma symreal input(x)
  double y = std::sin(x);
  if (symreal_requested("replay")) std::abort();
#pragma symreal output(y) generate("y.c")
  return 0;
}
