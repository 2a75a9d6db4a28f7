// Two kernels would be written to files of one name.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
double first(double x) {
#pragma symreal input(x)
  x = 2 * x;
#pragma symreal output(x) generate("twice.c")
  return x;
}
double second(double x) {
#pragma symreal input(x)
  x = x + x;
#pragma symreal output(x) generate("twice.c")
  return x;
}
int main() { return first(0.5) != second(0.5); }

// CHECK: kernels_of_one_name.cpp:13:{{[0-9]+}}: error: {{.*}} [SYM014]
// CHECK: help:
