// Sources that use REAL for something else: the number is spelled SYMREAL_REAL then, and all stays as it was.
// RUN: split-file %s %t && cd %t
// DEFINE: %{name} =
// DEFINE: %{try} = %symreal verify --numeric %{name}.cpp && %symreal rewrite --diff %{name}.cpp > %t.diff && FileCheck %s < %t.diff && %symreal generate --decisions=select %{name}.cpp -o %{name}.c
// REDEFINE: %{name} = macro
// RUN: cd %t && %{try}
// REDEFINE: %{name} = typedef
// RUN: %if all %{ cd %t && %{try} %}
// REDEFINE: %{name} = enumerator
// RUN: %if all %{ cd %t && %{try} %}
// REDEFINE: %{name} = variable
// RUN: %if all %{ cd %t && %{try} %}
// REDEFINE: %{name} = parameter
// RUN: cd %t && %{try}
// REDEFINE: %{name} = field
// RUN: cd %t && %{try}
// REDEFINE: %{name} = namespace
// RUN: %if all %{ cd %t && %{try} %}
// REDEFINE: %{name} = defined
// RUN: %if all %{ cd %t && %{try} %}
// RUN: cd %t && %symreal verify field.cpp field.c --samples=20
// CHECK: +{{.*}}SYMREAL_REAL 
// CHECK-NOT: {{[^_M]REAL_[A-Z]+\(}}
//--- macro.cpp
#define REAL float
#define REAL_C 3
double f(double x) { return x * REAL_C + (REAL)2; }
#include "main.h"
//--- typedef.cpp
typedef float REAL;
REAL const two = 2;
double f(double x) { return x + two + (double)(REAL)1; }
#include "main.h"
//--- enumerator.cpp
enum Kind { INTEGER, REAL, REAL_VALUE };
double f(double x) { return x + REAL + REAL_VALUE; }
#include "main.h"
//--- variable.cpp
static double const REAL = 2;
double f(double x) { return x * REAL; }
#include "main.h"
//--- parameter.cpp
template <class REAL> REAL twice(REAL x) { return x + x; }
double f(double x) { return twice<double>(x); }
#include "main.h"
//--- field.cpp
struct Values {
  double REAL;
  int REAL_TO;
};
double f(double x) {
  Values v = {x, 2};
  return v.REAL * v.REAL_TO;
}
#include "main.h"
//--- namespace.cpp
namespace REAL {
double g(double x) { return 2 * x; }
} // namespace REAL
double f(double x) { return REAL::g(x); }
#include "main.h"
//--- defined.cpp
#ifdef REAL
#error "this would be another program"
#endif
double f(double x) { return 2 * x; }
#include "main.h"
//--- main.h
#include <cstdio>
#include <cmath>
struct State {
  double v[2];
};
#pragma symreal function input(x) output(return)
double kernel(double x) {
  State s = {{x, 1.0}};
  double y = s.v[0] > -1e9 ? f(s.v[0]) : std::fmax(x, 0.0);
  for (int i = 0; i < 2; i++) y += s.v[i];
  return y;
}
int main() { std::printf("%g %d\n", kernel(0.5), (int)kernel(0.25)); }
