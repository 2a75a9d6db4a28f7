// A returned value that cannot be an output, since nothing in it is a double that an annotation reaches, or since the caller would
// get an object and not its value.
// RUN: not %symreal generate %s -o %t/ -- -std=c++20 2>&1 | FileCheck %s --implicit-check-not=SYM005 --implicit-check-not=SYM072
// RUN: not ls %t
// RUN: not %symreal generate %s -o %t.c --kernel 'plain(x=0.5) -> return' -- -std=c++20 2>&1 | FileCheck %s --check-prefix=CALL
// CALL: error: output(return): it is float, which holds no double [SYM026]
// RUN: not %symreal generate %s -o %t.c --wrapper --kernel=behind -- -std=c++20 -DPOINTER 2>&1 | FileCheck %s --check-prefix=POINTER
// POINTER: error: --wrapper cannot take the place of 'behind': it returns a pointer [SYM095]
#include <optional>
#include <tuple>

float plain(double x) { return static_cast<float>(x); }

#ifndef POINTER
// CHECK-DAG: :[[@LINE+1]]:42: error: output(return): it is float, which holds no double [SYM026]
#pragma symreal function input(x) output(return)
float narrow(double x) { return static_cast<float>(x); }
// CHECK-DAG: :[[@LINE+1]]:42: error: output(return): it is std::optional<double>, whose numbers no annotation reaches: return a structure or an array of them [SYM026]
#pragma symreal function input(x) output(return)
std::optional<double> maybe(double x) { return x * 2; }
// CHECK-DAG: :[[@LINE+1]]:42: error: output(return): it is std::tuple<double, double>, whose numbers no annotation reaches
#pragma symreal function input(x) output(return)
std::tuple<double, double> both(double x) { return {x * 2, x}; }
// CHECK-DAG: :[[@LINE+1]]:47: error: output(return): it is double &, which hands out an object: name that in output(...) [SYM026]
#pragma symreal function input(x[0:2]) output(return)
double &element(double *x) { return x[1] *= x[0]; }
int main() {
  double x[2] = {1, 2};
  return narrow(1) + *maybe(1) + std::get<0>(both(1)) + element(x) > 100;
}
#else
#pragma symreal function input(x[0:2]) output(x[0:2])
double *behind(double *x) { return x[1] *= x[0], x + 1; }
int main() {
  double x[2] = {1, 2};
  return *behind(x) > 100;
}
#endif
