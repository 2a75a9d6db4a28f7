// Every place where a type can stand.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

// CHECK: typedef REAL number;
typedef double number;
// CHECK: using Row = REAL[3];
using Row = double[3];
// CHECK: typedef REAL (*function)(REAL, REAL const *);
typedef double (*function)(double, double const *);
// CHECK: struct S { REAL_MEMBERS(public, x, a, m) REAL x; REAL const *p; REAL a[2][3]; mutable REAL m; };
struct S { double x; double const *p; double a[2][3]; mutable double m; };
// CHECK: union U { REAL d; long bits; };
union U { double d; long bits; };
// CHECK: template <class T = REAL> struct Box { REAL_MEMBERS(public, value) T value; operator REAL() const { return REAL(value); } };
template <class T = double> struct Box { T value; operator double() const { return double(value); } };
// CHECK: template <> struct Box<REAL> { REAL_MEMBERS(public, value) REAL value; };
template <> struct Box<double> { double value; };
// CHECK: template <class T> REAL twice(T x) { REAL y = x; return static_cast<REAL>(y + x); }
template <class T> double twice(T x) { double y = x; return static_cast<double>(y + x); }
// CHECK: unsigned long f(REAL x, int n = sizeof(REAL)) {
unsigned long f(double x, int n = sizeof(double)) {
  // CHECK: std::vector<REAL> v(3); std::array<REAL, 2> a = {x, x}; std::map<int, std::vector<REAL>> m;
  std::vector<double> v(3); std::array<double, 2> a = {x, x}; std::map<int, std::vector<double>> m;
  // CHECK: REAL *h = new REAL[4]; delete[] h; std::unique_ptr<REAL[]> u(new REAL[2]);
  double *h = new double[4]; delete[] h; std::unique_ptr<double[]> u(new double[2]);
  // CHECK: std::function<REAL(REAL)> g = [](REAL t) -> REAL { return t; };
  std::function<double(double)> g = [](double t) -> double { return t; };
  // CHECK: REAL const &r = x; volatile REAL w = 1; auto z = (REAL)n; auto q = std::make_unique<REAL>(x);
  double const &r = x; volatile double w = 1; auto z = (double)n; auto q = std::make_unique<double>(x);
  // CHECK: return v.size() + sizeof(REAL[3]) + alignof(REAL) + static_cast<unsigned long>(twice<REAL>(x));
  return v.size() + sizeof(double[3]) + alignof(double) + static_cast<unsigned long>(twice<double>(x));
}
