// What is no part of an annotated structure is told: what pointers point to, numbers that are no double.
// RUN: %symreal generate %s -o %t.c --frozen=allow 2>&1 | FileCheck %s
struct Model {
  double mass;
  double *table;
  double *other;
  float gain;
  char name[8];
};

// CHECK: left_out.cpp:[[@LINE+3]]:32: warning: 'model' does not include what its members 'table' point to [SYM072]
// CHECK: left_out.cpp:[[@LINE+2]]:32: warning: 'model' has members that are not double
// CHECK-SAME: and stay as they are: 'gain' [SYM072]
#pragma symreal function input(model, model.other[0 : 2]) output(return)
double force(Model &model) { return model.mass * model.table[0] * model.gain - model.other[1]; }

int main() {
  double table[1] = {3}, other[2] = {4, 5};
  Model model{1, table, other, 0.5f, "m"};
  return force(model) == 0;
}
