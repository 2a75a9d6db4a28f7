// A sample on which the original crashes costs that sample its process, not the tool.
// RUN: %symreal generate %s -o %t.c
// RUN: not %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
// CHECK: verify_crash.cpp:10:{{[0-9]+}}: error: signal {{[0-9]+}} {{.*}} ended the original's kernel on a sample [SYM093]
#include <cmath>
#include <cstdlib>

int main() {
  double x = 0.5;
#pragma symreal input(x)
  double y = std::sin(x);
  if (std::getenv("SYMREAL_REPLAY")) std::abort();
#pragma symreal output(y) generate("y.c")
  return 0;
}
