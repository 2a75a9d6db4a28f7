// Two different expressions may be equal for some inputs: their comparison is recorded, never answered by their form.
// Only a value compared with itself is, and where that rests on a premise it is said.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: %symreal generate %s -o %t.c --decisions=guard 2>&1 | FileCheck %s --check-prefix=GUARD
// RUN: %symreal verify --samples=100 %s %t.c --min-samples 1
// RUN: not %symreal generate %s -o %t.c --fp=strict 2>&1 | FileCheck %s --check-prefix=STRICT
#include <cstdio>

#pragma symreal function input(x, y) output(return)
double compare(double x, double y) {
  double result = x;
  if (x == y) result += 1.0;
  if (x + y != y + x + 1.0) result += 2.0;
  if (x * y == x * y) result += 4.0;
  return result;
}

int main() { std::printf("%g\n", compare(0.5, 2.0)); }

// CHECK-DAG: equality.cpp:13:{{[0-9]+}}: error: the program decides on a symbolic value: x == y
// CHECK-DAG: equality.cpp:14:{{[0-9]+}}: error: the program decides on a symbolic value: {{.*}} != {{.*}}
// CHECK-DAG: equality.cpp:15:{{[0-9]+}}: remark: {{.*}} is constant: in mode finite every value is finite [SYM059]
// GUARD: guard 1 {{ *}}equality.cpp:13:3: x == y is false
// GUARD: guard 2 {{.*}} != 
// STRICT: equality.cpp:15:{{[0-9]+}}: error: the program decides on a symbolic value
