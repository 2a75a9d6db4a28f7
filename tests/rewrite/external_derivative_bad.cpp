// What cannot be the derivative of an external function, and why.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
extern "C" {
double f(double x, double y);
double g(double x);
void good(double x, double y, double *partials);
void few(double x, double *partials);
void other(double x, int y, double *partials);
void sized(double x, double y, double partials[3]);
double given(double x, double y);
void constant(double x, double y, double const *partials);
void ours(double x, double y, double *partials) { partials[0] = x, partials[1] = y; }
}
void cpp(double x, double y, double *partials);

// CHECK-DAG: bad.cpp:[[@LINE+1]]:45: error: no function 'missing' is declared in this file [SYM023]
#pragma symreal external(f) pure derivative(missing)
// CHECK-DAG: bad.cpp:[[@LINE+1]]:45: error: 'few' cannot be the derivative: it should be void (double, double, double partials[2]) [SYM186]
#pragma symreal external(f) pure derivative(few)
// CHECK-DAG: bad.cpp:[[@LINE+1]]:45: error: 'other' cannot be the derivative: it should be void
#pragma symreal external(f) pure derivative(other)
// CHECK-DAG: bad.cpp:[[@LINE+1]]:45: error: 'sized' cannot be the derivative: {{.*}}, and its array has 3 elements
#pragma symreal external(f) pure derivative(sized)
// CHECK-DAG: bad.cpp:[[@LINE+1]]:45: error: 'given' cannot be the derivative: it should be void
#pragma symreal external(f) pure derivative(given)
// CHECK-DAG: bad.cpp:[[@LINE+1]]:45: error: 'constant' cannot be the derivative
#pragma symreal external(f) pure derivative(constant)
// CHECK-DAG: bad.cpp:[[@LINE+1]]:45: error: 'ours' is defined in the sources
#pragma symreal external(f) pure derivative(ours)
// CHECK-DAG: bad.cpp:[[@LINE+1]]:45: error: 'cpp' has C++ linkage
#pragma symreal external(f) pure derivative(cpp)
// CHECK-DAG: bad.cpp:[[@LINE+1]]:40: error: 'good' cannot be the derivative: 'f' is not said to be pure [SYM186]
#pragma symreal external(f) derivative(good)
// CHECK-DAG: bad.cpp:[[@LINE+1]]:51: error: 'given' cannot be the derivative: it should be void (double, double, double partials[4])
#pragma symreal external(f) pure derivative(good, given)
// CHECK-DAG: bad.cpp:[[@LINE+1]]:48: error: 'derivative' stands there twice
#pragma symreal external(g) pure derivative(g) derivative(g)
// CHECK-DAG: bad.cpp:[[@LINE+1]]:17: error: {{.*}}derivative
#pragma symreal derivative(good)
