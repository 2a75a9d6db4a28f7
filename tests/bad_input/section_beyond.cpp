// A section beyond an object whose size its declaration tells is an error at the annotation, with the size; the program is not run.
// RUN: not %symreal generate %s -o %t.c -- -std=c++20 2>&1 | FileCheck %s --implicit-check-not='error:'
// RUN: not ls %t.c
// RUN: %symreal scan %s -- -std=c++20 | FileCheck %s --check-prefix=SCAN
// SCAN: 12 SYM203 a section reaches beyond its object; first at
// RUN: not %symreal generate %s --kernel 'plain(h[0:5]=0.5) -> return' -o %t.c 2>&1 | FileCheck %s --check-prefix=LINE
// LINE: --kernel:1:7: error: 'h[0:5]' reaches beyond 'h', which has 4 elements [SYM203]
// LINE: help: give the section the length of the object
// RUN: echo "kernels: [{function: plain, inputs: ['h[2:3]'], outputs: [return]}]" > %t.yaml
// RUN: not %symreal generate %s --config %t.yaml -o %t.c 2>&1 | FileCheck %s --check-prefix=YAML
// YAML: {{.*}}.yaml:1:{{[0-9]+}}: error: 'h[2:3]' reaches beyond 'h', which has 4 elements [SYM203]
#include <array>

constexpr int degrees = 3;
enum { wheels = 2 };
struct Body {
  double x[4], inertia[3][2];
  std::array<double, 3> v;
};
typedef double Row[2];

double plain(double const h[4]) { return h[0]; }

// CHECK-DAG: section_beyond.cpp:[[@LINE+1]]:32: error: 'h[0:8]' reaches beyond 'h', which has 4 elements [SYM203]
#pragma symreal function input(h[0:8]) output(return)
double parameter(double h[4]) { return h[0]; }
// CHECK-DAG: section_beyond.cpp:[[@LINE+1]]:32: error: 'a[2:degrees]' reaches beyond 'a', which has 4 elements [SYM203]
#pragma symreal function input(a[2:degrees]) output(return)
double reference(double (&a)[4]) { return a[0]; }
// CHECK-DAG: section_beyond.cpp:[[@LINE+1]]:36: error: 'm[0:3][0:3]' reaches beyond the rows 'm[0:3]', which have 2 elements each [SYM203]
#pragma symreal function parameter(m[0:3][0:3]) output(return)
double columns(double m[3][2]) { return m[0][0]; }
// CHECK-DAG: section_beyond.cpp:[[@LINE+1]]:32: error: 'm[0:degrees+1][0:wheels]' reaches beyond 'm', which has 3 elements [SYM203]
#pragma symreal function input(m[0:degrees+1][0:wheels]) output(return)
double rows(double m[3][2]) { return m[0][0]; }
// CHECK-DAG: section_beyond.cpp:[[@LINE+3]]:32: error: 'b->x[3:2]' reaches beyond 'b->x', which has 4 elements [SYM203]
// CHECK-DAG: section_beyond.cpp:[[@LINE+2]]:43: error: 'b->inertia[2][1:2]' reaches beyond 'b->inertia[2]', which has 2 elements [SYM203]
// CHECK-DAG: section_beyond.cpp:[[@LINE+1]]:71: error: 'b->v[0:4]' reaches beyond 'b->v', which has 3 elements [SYM203]
#pragma symreal function input(b->x[3:2], b->inertia[2][1:2]) scratch(b->v[0:4]) output(return)
double members(Body *b) { return b->x[0]; }
// CHECK-DAG: section_beyond.cpp:[[@LINE+2]]:32: error: 'p[0][0:3]' reaches beyond 'p[0]', which has 2 elements [SYM203]
// CHECK-DAG: section_beyond.cpp:[[@LINE+1]]:50: error: 'y[4]' reaches beyond 'y', which has 4 elements [SYM203]
#pragma symreal function input(p[0][0:3]) output(y[4])
void behind(Row const *p, double y[4]) { y[0] = p[0][0]; }
// CHECK-DAG: section_beyond.cpp:[[@LINE+1]]:32: error: 'a[-1:2]' reaches beyond 'a', which has 4 elements [SYM203]
#pragma symreal function input(a[-1:2]) output(return)
double before(double (&a)[4]) { return a[0]; }

int main() {
  double local[3] = {1, 2, 3};
  static double grid[2][2];
// CHECK-DAG: section_beyond.cpp:[[@LINE+1]]:23: error: 'local[0:4]' reaches beyond 'local', which has 3 elements [SYM203]
#pragma symreal input(local[0:4])
  grid[0][0] = local[0] * 2;
// CHECK-DAG: section_beyond.cpp:[[@LINE+1]]:24: error: 'grid[0:2][0:3]' reaches beyond the rows 'grid[0:2]', which have 2 elements each [SYM203]
#pragma symreal output(grid[0:2][0:3])
#pragma symreal generate("local.c")
}
