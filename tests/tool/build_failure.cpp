// What compiles with double and not with REAL is reported where it stands in the source, by line and column.
// RUN: rm -rf %t && mkdir %t
// RUN: not %symreal generate %s -o %t/a.c 2>&1 | FileCheck %s
// CHECK: build_failure.cpp:[[#@LINE+5]]:{{[0-9]+}}: error: the program does not compile in symbolic mode: {{.*}}[SYM005]
// RUN: ls -A %t | count 0
int main() {
  double x = 1;
#pragma symreal input(x)
  x = __builtin_powi(x, 2);
#pragma symreal output(x) generate("x.c")
}
