// --kernel in C++: methods of an object that is named, static and overloaded functions, references, containers, matrices,
// complex numbers, what needs an expression.
// DEFINE: %{call} =
// DEFINE: %{flags} =
// DEFINE: %{run} = %symreal generate %s --kernel %{call} -o %t.c %{flags} 2> %t.log && %symreal verify %s %t.c --samples=100 --min-samples=10 --kernel %{call} %{flags} 2>> %t.log

// REDEFINE: %{call} = 'veh::Bicycle(2.7, 1.1).derivative(x[0:3]=0.5, u[0:2]) -> dx[0:3]'
// RUN: %{run} && FileCheck %s --check-prefix=OBJECT < %t.log
// OBJECT: kernel derivative: 5 inputs, 0 parameters, 3 outputs
// OBJECT: kernel derivative, mode finite: 100 samples

// An object that is made by default, members of the elements of an array, and one of several functions, by its arguments; an
// object that a function gives, and one of several functions, by its types.
// RUN: rm -rf %t && mkdir -p %t/a %t/b && cp %s %t/a/cxx.cpp && cp %s %t/b/cxx.cpp
// RUN: cp %S/Inputs/call_cxx_a.yaml %t/a/.symreal.yaml && cp %S/Inputs/call_cxx_b.yaml %t/b/.symreal.yaml
// RUN: cd %t/a && %symreal generate cxx.cpp -o ./ 2> log && %symreal verify cxx.cpp derivative.c total.c scale.c --samples=100 --min-samples=10 2>> log && FileCheck %s < log
// CHECK: kernel derivative: 5 inputs, 2 parameters, 3 outputs
// CHECK: kernel total: 4 inputs, 0 parameters, 1 outputs
// CHECK: kernel scale: 2 inputs, 0 parameters, 2 outputs
// CHECK: kernel derivative, mode finite: 100 samples
// CHECK: kernel total, mode finite: 100 samples
// CHECK: kernel scale, mode finite: 100 samples
// RUN: cd %t/b && %symreal generate cxx.cpp -o ./ 2> log && %symreal verify cxx.cpp derivative.c scale.c --samples=100 --min-samples=10 2>> log && FileCheck %s --check-prefix=MADE < log
// MADE: kernel derivative: 5 inputs, 0 parameters, 3 outputs
// MADE: kernel scale: 1 inputs, 0 parameters, 1 outputs
// MADE: kernel derivative, mode finite: 100 samples
// MADE: kernel scale, mode finite: 100 samples

// REDEFINE: %{flags} = -- -DMATRICES -I/usr/include/eigen3
// REDEFINE: %{call} = 'veh::mix(x[0:3]={1, 2, 3}, m[0:2][0:2]=-1..1, r=0.25, z=1, s.a=2, s.b=3) -> x[0:3], z, return'
// RUN: %if all %{ %{run} && FileCheck %s --check-prefix=MIX < %t.log %}
// MIX: kernel mix: 12 inputs, 0 parameters, 6 outputs
// MIX: kernel mix, mode finite: 100 samples
// REDEFINE: %{call} = 'scale(v[0:3]=1) -> v[0:3]'
// RUN: %if all %{ %{run} && FileCheck %s --check-prefix=FIXED < %t.log %}
// FIXED: kernel scale: 3 inputs, 0 parameters, 3 outputs
// RUN: not %symreal generate %s --kernel 'scale(v[0:3]={1, 2}) -> v' -o %t.c %{flags} 2>&1 | FileCheck %s --check-prefix=FEW
// FEW: --kernel:1:1: error: 3 functions 'scale' do not take these arguments: write the types of its parameters
// FEW: note: scale(double *, int)
// RUN: not %symreal generate %s --kernel 'scale(v=1) -> v' -o %t.c %{flags} 2>&1 | FileCheck %s --check-prefix=MANY
// MANY: --kernel:1:1: error: 2 functions 'scale' take these arguments: write the types of its parameters
#ifdef MATRICES // which take long to compile
#include <Eigen/Dense>
#include <complex>
#include <vector>
#endif
#include <cmath>
#include <cstring>

namespace veh {
class Bicycle {
public:
  Bicycle() : Bicycle(2, 1) {}
  Bicycle(double wheelbase, double offset) : wheelbase_(wheelbase), offset_(offset) {}
  void derivative(double const *x, double const (&u)[2], double *dx) const {
    double const beta = std::atan(offset_ / wheelbase_ * std::tan(u[1]));
    dx[0] = u[0] * std::cos(x[2] + beta);
    dx[1] = u[0] * std::sin(x[2] + beta) + x[0];
    dx[2] = u[0] / offset_ * std::sin(beta) + x[1];
  }

private:
  double wheelbase_, offset_;
};
Bicycle make(char const *size) { return std::strcmp(size, "small") == 0 ? Bicycle(1, 0.5) : Bicycle(3, 1.5); }

struct Sides {
  double a, b;
};
#ifdef MATRICES
double mix(std::vector<double> &x, Eigen::MatrixXd const &m, double &&r, std::complex<double> &z, Sides s) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] *= s.a;
  z *= 2;
  return m.trace() * r - s.b;
}
#endif
double total(Sides const *p) { return p[0].a * p[1].a + p[0].b - p[1].b; }
} // namespace veh

#ifdef MATRICES
static void scale(Eigen::Vector3d &v) { v *= 2; }
#endif
static void scale(double &v) { v *= 2; }
void scale(double *v, int n) {
  for (int i = 0; i < n; ++i) v[i] *= 2;
}
