// What only a compiler knows can be foreseen as well, before a program is built.
// RUN: %symreal scan %s | FileCheck %s --check-prefix=READ
// RUN: not %symreal scan --compile %s --list > %t.txt
// RUN: FileCheck %s < %t.txt
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s --check-prefix=BUILT
// READ-NOT: SYM005
// CHECK: obstacles
// CHECK: SYM005
// CHECK: what blocks it
// CHECK: compile.cpp:[[#@LINE+2]]:{{[0-9]+}}: the program does not compile in symbolic mode: invalid vector type for attribute 'vector_size' [SYM005]
// BUILT: compile.cpp:[[#@LINE+1]]:{{[0-9]+}}: error: the program does not compile in symbolic mode: invalid vector type
typedef double pair __attribute__((vector_size(16)));

double squares(double x, double y) {
  pair const both = {x, y};
  pair const product = both * both;
  return product[0] + product[1];
}

int main() {
  double x = 1, y = 2, z;
#pragma symreal input(x, y)
  z = squares(x, y);
#pragma symreal output(z) generate("z.c")
  return z < 0;
}
