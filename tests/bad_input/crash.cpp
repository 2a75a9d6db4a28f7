// The program is ended by a signal within its kernel.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>
#include <cstdlib>

static double *table(char const *name) { return static_cast<double *>(static_cast<void *>(std::getenv(name))); }

int main() {
  double x = 0.5;
#pragma symreal input(x)
  double *offset = table("NO_SUCH_VARIABLE_OF_THE_ENVIRONMENT");
  *offset = 2.0;
  double y = std::sin(x) + *offset;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}

// CHECK: crash.cpp:15:{{[0-9]+}}: error: {{.*}}; it stood here [SYM007]
// CHECK: crash.cpp:13:{{[0-9]+}}: note: Symreal waited for this
// CHECK: help:
