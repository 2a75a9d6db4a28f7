// A state and its derivative by time are recorded with the kernel, and are no numbers of it.
// RUN: %rewrite %s 2>&1 | FileCheck %s
// RUN: %symreal generate %s -o %t.c --graph %t.graph
// RUN: FileCheck %s --check-prefix=GRAPH --input-file=%t.graph
// RUN: %symreal opt %t.graph | FileCheck %s --check-prefix=GRAPH
// RUN: %symreal verify %s %t.c --samples=200
// RUN: %symreal verify --numeric %s
#include <cstdio>

int main() {
  double x[2] = {1, 2}, v = 3, dx[2], dv;
  {
#pragma symreal input(x, v)
    dx[0] = v * x[1];
    dx[1] = -x[0];
    dv = -v;
#pragma symreal output(dx, dv) state(v, dv) state(x, dx) generate("state.c")
  }
  std::printf("%g %g\n", dx[0], dv);
}

// CHECK: SYMREAL_STATE("v", "{{.*}}state.cpp", [[#@LINE-5]], {{[0-9]+}}, "dv") SYMREAL_STATE("x", {{.*}}, "dx") SYMREAL_GENERATE
// GRAPH: output "dv"
// GRAPH-NEXT: state "v" "dv" at "{{.*}}state.cpp"
// GRAPH-NEXT: state "x" "dx" at "{{.*}}state.cpp"
