// --kernel on what is no plain function: operators, call operators, conversions, instances of templates, inline namespaces,
// pointers, containers and integers in structures.
// RUN: rm -rf %t && mkdir %t && cp %S/Inputs/call_forms.yaml %t/.symreal.yaml && cp %s %t/forms.cpp
// RUN: cd %t && %symreal generate forms.cpp -o ./ 2> generated && FileCheck %s < generated
// CHECK: kernel operator*: 4 inputs, 0 parameters, 2 outputs
// CHECK: kernel twice: 1 inputs, 0 parameters, 1 outputs
// CHECK: kernel operator(): 1 inputs, 0 parameters, 1 outputs
// CHECK: kernel operator double: 1 inputs, 0 parameters, 1 outputs
// CHECK: kernel dot: 3 inputs, 0 parameters, 1 outputs
// CHECK: kernel apply: 1 inputs, 0 parameters, 1 outputs
// CHECK: kernel look: 7 inputs, 1 parameters, 1 outputs
// RUN: cd %t && %symreal verify forms.cpp *.c --samples=100 2> verified && FileCheck %s --check-prefix=VERIFIED < verified
// VERIFIED-COUNT-7: mode finite: 100 samples
// The name that a call operator has.
// DEFINE: %{call} = 'Gain(2.0).operator()(x=-1..1) -> return'
// RUN: %symreal generate %s --kernel %{call} -o %t.c 2>&1 | FileCheck %s --check-prefix=CALL
// CALL: kernel operator(): 1 inputs, 0 parameters, 1 outputs
// RUN: %symreal verify %s %t.c --kernel %{call} --samples=100
// REDEFINE: %{call} = 'Gain(2.0).operator double()(factor=0.5) -> return'
// RUN: not %symreal generate %s --kernel %{call} -o %t.c 2>&1 | FileCheck %s --check-prefix=MEMBER
// MEMBER: --kernel:1:29: error: 'factor' is not an argument of 'Gain::operator double'; a member has the value that the object is made with [SYM018]

// REDEFINE: %{call} = 'dot<double>(x[0:3]=0.5) -> return'
// RUN: not %symreal generate %s --kernel %{call} -o %t.c 2>&1 | FileCheck %s --check-prefix=ARGUMENTS
// ARGUMENTS: --kernel:1:1: error: no source defines a function 'dot<double>', with all arguments of one template [SYM113]
// REDEFINE: %{call} = 'Loss(2.0)(x=1) -> return'
// RUN: not %symreal generate %s --kernel %{call} -o %t.c 2>&1 | FileCheck %s --check-prefix=CLASS
// CLASS: --kernel:1:1: error: no source defines a function 'Loss' [SYM113]

#include <vector>

namespace ns {
struct Pair {
  double x, y;
};
Pair operator*(Pair const &a, Pair const &b) { return Pair{a.x * b.x, a.y * b.y}; }
inline namespace v1 {
double twice(double x) { return 2 * x; }
} // namespace v1
} // namespace ns

struct Gain {
  double factor;
  explicit Gain(double f) : factor(f) {}
  double operator()(double x) const { return factor * x; }
  explicit operator double() const { return factor * factor; }
};

template <class T, int n> T dot(T const *x) {
  T sum = 0;
  for (int i = 0; i < n; ++i) sum += x[i] * x[i];
  return sum;
}

template <class T> class Scaled {
  T factor_;

public:
  explicit Scaled(T factor) : factor_(factor) {}
  T apply(T x) const { return factor_ * x; }
};

struct Table {
  int n;
  double x0, *values;
  std::vector<double> v;
};
void look(Table *t, double r, double *f) { *f = t->values[t->n] * r + t->x0 + t->v[2]; }
