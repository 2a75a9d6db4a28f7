// A kernel has an end and an output.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
double block(double x) {
  // CHECK-DAG: pragma_incomplete.cpp:[[@LINE+1]]:1: error: no generate("...") follows these annotations [SYM028]
#pragma symreal input(x)
  return x;
}
// CHECK-DAG: pragma_incomplete.cpp:[[@LINE+1]]:1: error: this pragma has no output(...) [SYM028]
#pragma symreal function input(x)
double function(double x) { return x; }
