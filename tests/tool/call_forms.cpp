// --kernel on what is no plain function: operators, call operators, conversions, instances of templates, inline namespaces,
// pointers, containers and integers in structures.
// DEFINE: %{call} =
// DEFINE: %{flags} =
// DEFINE: %{run} = %symreal generate %s --kernel %{call} -o %t.c %{flags} 2> %t.log && %symreal verify %s %t.c --samples 100 --kernel %{call} %{flags} 2>> %t.log && FileCheck %s --input-file=%t.log --check-prefix

// REDEFINE: %{call} = 'ns::operator*(a.x=1, a.y=2, b.x=3, b.y=4) -> return'
// RUN: %{run}=PLUS
// PLUS: kernel operator*: 4 inputs, 0 parameters, 2 outputs
// REDEFINE: %{call} = 'Gain(2.0)(x=1) -> return'
// RUN: %{run}=CALL
// CALL: kernel operator(): 1 inputs, 0 parameters, 1 outputs
// REDEFINE: %{call} = 'Gain(2.0).operator()(x=-1..1) -> return'
// RUN: %{run}=CALL
// REDEFINE: %{call} = 'Gain(2.0).operator double()(factor=0.5) -> return'
// RUN: not %symreal generate %s --kernel %{call} -o %t.c 2>&1 | FileCheck %s --check-prefix=MEMBER
// MEMBER: --kernel:1:29: error: 'factor' is not an argument of 'Gain::operator double'; a member has the value that the object is made with [SYM018]
// REDEFINE: %{call} = 'Gain(2.0).operator double()(factor) -> return'
// RUN: %{run}=CONVERT
// CONVERT: kernel operator double: 1 inputs, 0 parameters, 1 outputs
// REDEFINE: %{call} = 'dot<double, 3>(x[0:3]=0.5) -> return'
// RUN: %{run}=DOT
// DOT: kernel dot: 3 inputs, 0 parameters, 1 outputs
// REDEFINE: %{call} = 'Scaled<double>(2.0).apply(x=0.5) -> return'
// RUN: %{run}=APPLY
// APPLY: kernel apply: 1 inputs, 0 parameters, 1 outputs
// REDEFINE: %{call} = 'ns::v1::twice(x=1) -> return'
// RUN: %{run}=TWICE
// TWICE: kernel twice: 1 inputs, 0 parameters, 1 outputs
// REDEFINE: %{call} = 'look(parameter t->x0=2, t->n=3, t->values[0:4]={1, 2, 3, 4}, t->v[1:2]={5, 6}, r=0.5) -> *f'
// REDEFINE: %{flags} = -- -DCONTAINER
// RUN: %{run}=LOOK
// LOOK: kernel look: 7 inputs, 1 parameters, 1 outputs

// REDEFINE: %{call} = 'dot<double>(x[0:3]=0.5) -> return'
// RUN: not %symreal generate %s --kernel %{call} -o %t.c 2>&1 | FileCheck %s --check-prefix=ARGUMENTS
// ARGUMENTS: --kernel:1:1: error: no source defines a function 'dot<double>', with all arguments of one template [SYM113]
// REDEFINE: %{call} = 'Loss(2.0)(x=1) -> return'
// RUN: not %symreal generate %s --kernel %{call} -o %t.c 2>&1 | FileCheck %s --check-prefix=CLASS
// CLASS: --kernel:1:1: error: no source defines a function 'Loss' [SYM113]
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

#ifdef CONTAINER // whose header takes longer than all else
#include <vector>
struct Table {
  int n;
  double x0, *values;
  std::vector<double> v;
};
void look(Table *t, double r, double *f) { *f = t->values[t->n] * r + t->x0 + t->v[2]; }
#endif
