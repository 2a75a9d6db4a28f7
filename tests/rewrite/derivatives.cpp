// Derivatives that a pragma asks for are further outputs; the graph of the recording says what is wanted, and opt makes them of it.
// RUN: rm -rf %t && mkdir %t
// RUN: %rewrite %s 2>&1 | FileCheck %s
// CHECK: SYMREAL_DIFFERENTIATE("gradient(return)", "{{.*}}derivatives.cpp", [[#@LINE+15]], {{[0-9]+}})
// CHECK: SYMREAL_DIFFERENTIATE("jacobian(y, [x, p])", "{{.*}}derivatives.cpp", [[#@LINE+23]], {{[0-9]+}}) SYMREAL_GENERATE
// RUN: %symreal generate %s -o %t/k --graph %t/graphs
// RUN: FileCheck %s --check-prefix=GRAPH --input-file=%t/graphs/region.graph
// GRAPH: output "y[0:2]" [2]
// GRAPH-NEXT: differentiate "jacobian(y, [x, p])" at "{{.*}}derivatives.cpp"
// GRAPH-NOT: jacobian_y_x_p
// RUN: %symreal opt %t/graphs/region.graph --lang=c -o %t/opt.c && FileCheck %s --check-prefix=HEADER --input-file=%t/opt.h
// RUN: FileCheck %s --check-prefix=HEADER --input-file=%t/k/region.h
// HEADER: double jacobian_y_x_p[2][3];
// RUN: %symreal verify %s %t/k/region.c --samples=200
// RUN: %symreal verify %s %t/k/energy.c --samples=200
// RUN: %symreal verify --numeric %s
#include <cstdio>

#pragma symreal function input(m, v) range(-9, 9) output(return) gradient(return)
double energy(double m, double v) { return 0.5 * m * v * v; }

int main() {
  double x[2] = {1, 2}, p = 3, y[2];
  {
#pragma symreal input(x[0:2], p) range(-9, 9)
    y[0] = p * x[0] * x[1];
    y[1] = x[0] - p * p;
#pragma symreal output(y[0:2]) jacobian(y, [x, p]) generate("region.c")
  }
  std::printf("%g %g %g\n", y[0], y[1], energy(p, x[0]));
}
