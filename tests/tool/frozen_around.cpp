// A block kernel bakes in what it reads of the locals around it: they are listed, and an error with --frozen=error. What
// it writes before it reads it, and what it may change, is its own business.
// RUN: %same %s && rm -rf %t && mkdir %t
// RUN: %rewrite %s | FileCheck %s --check-prefix=TEXT
// RUN: %symreal generate %s -o %t/pull.c 2>&1 | FileCheck %s --implicit-check-not="baked in" --implicit-check-not="[SYM"
// CHECK: baked in p = 3 ({{.*}}frozen_around.cpp:30:10)
// CHECK: baked in n = 3 ({{.*}}frozen_around.cpp:32:7)
// CHECK: baked in k = 9.81 ({{.*}}frozen_around.cpp:33:10)
// CHECK: baked in table = 1, 2, 4 ({{.*}}frozen_around.cpp:33:29)
// CHECK: baked in sum = 0 ({{.*}}frozen_around.cpp:33:69)
// RUN: FileCheck %s --check-prefix=HEADER < %t/pull.h
// HEADER: /* Baked in with the values that the program had there when this was recorded:
// HEADER-DAG: k = 9.81
// HEADER-DAG: p = 3
// RUN: %symreal verify %s %t/pull.c --samples=100
// RUN: rm %t/pull.c && not %symreal generate %s -o %t/pull.c --frozen=error 2>&1 | FileCheck %s --check-prefix=ERROR
// RUN: not ls %t/pull.c
// ERROR-DAG: frozen_around.cpp:{{[0-9:]+}}: error: kernel 'pull' reads 'k' (9.81), which is neither input nor parameter [SYM017]
// ERROR-DAG: frozen_around.cpp:{{[0-9:]+}}: error: kernel 'pull' reads 'p' (3), which is
// ERROR-DAG: frozen_around.cpp:{{[0-9:]+}}: error: kernel 'pull' reads 'n' (3), which is
#include <cstdio>

struct Planet { double a, b; int degree; };
static double pull(Planet const *p) { return p->a * p->b; }

// TEXT: SYMREAL_AROUND("p", "{{.*}}:30:10", p) SYMREAL_AROUND("n", {{.*}}) SYMREAL_AROUND("k", {{.*}}, k)
// TEXT: product = x * REAL_READ("k", {{.*}}, k) * known;
// TEXT: printf("%g %g %g %d\n", REAL_VALUE(sum), REAL_VALUE(y), REAL_VALUE(work[1]), unused);
int main() {
  Planet p = {2, 3, 4};
  double const known = 0.5;
  int n = 3, i, unused = 5, first = 1;
  double k = 9.81, product, table[3] = {1, 2, 4}, work[2] = {7, 8}, sum = 0;
  double x = 1.5, y;
#pragma symreal input(p.a, x)
  product = x * k * known;
  y = pull(&p) + product;
  for (i = 0, first = 0; i < n; i++) y += table[i] * x;
  work[first] = x;
  sum += y * work[0];
#pragma symreal output(sum, y) generate("pull.c")
  std::printf("%g %g %g %d\n", sum, y, work[1], unused);
}
