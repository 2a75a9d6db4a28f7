// A function without a definition.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// CHECK: link_failure.cpp:10: error: undefined reference to `missing(int)' [SYM006]
void missing(int);

int main() {
  double x = 1;
#pragma symreal input(x)
  x = x * x;
  missing(1);
#pragma symreal output(x) generate("x.c")
}
