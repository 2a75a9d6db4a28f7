// A pragma before a function: its annotations stand behind the brace, its returns report what they return.
// RUN: cd %S && %symreal rewrite --out-root %t pragma_function.cpp && grep -v CHECK: %t/pragma_function.cpp | FileCheck pragma_function.cpp
// RUN: %same %s
struct Arm {
  double m;
  template <class T> T torque(T const *q, int n);
};

// CHECK: {{^$}}
#pragma symreal function input(q[0:n]) parameter(m) output(return) call(2)
// Comments may stand between.
template <class T>
// CHECK: T Arm::torque(T const *q, int n) { SYMREAL_FUNCTION("torque", "pragma_function.cpp", [[@LINE-3]], 1, (::symreal::symreal_call_of<decltype(q), decltype(m)>(2))) SYMREAL_REBIND(q, 0, n) SYMREAL_SECTION(input, "q[0:n]", {{.*}}) SYMREAL_OBJECT(parameter, "m", "pragma_function.cpp", [[@LINE-3]], 50, ::symreal::symreal_instance(m)) SYMREAL_ARGUMENT("n", "pragma_function.cpp:[[@LINE+1]]:31", n) SYMREAL_LEADS(q) SYMREAL_LEADS(this) SYMREAL_OUTPUTS_BEGIN SYMREAL_OUTPUTS_END{{$}}
T Arm::torque(T const *q, int n) {
  auto twice = [](T x) { return x + x; };
  // CHECK: if (n == 0) return SYMREAL_RETURN("return", "pragma_function.cpp", [[@LINE-6]], 60, REAL_READ({{.*}}, m));
  if (n == 0) return m;
  // CHECK: return SYMREAL_RETURN("return", "pragma_function.cpp", {{[0-9]+}}, 60, REAL_READ({{.*}}, m) * twice(q[0]));
  return m * twice(q[0]);
}

#pragma symreal function input(x) output(y[0:2], a)
// CHECK: void scale(REAL x, REAL *y, REAL a[2]) { SYMREAL_FUNCTION("scale", {{.*}}) SYMREAL_OBJECT(input, "x", {{.*}}, x) SYMREAL_LEADS(y) SYMREAL_LEADS(a) SYMREAL_OUTPUTS_BEGIN SYMREAL_SECTION(output, "y[0:2]", {{.*}}) SYMREAL_SECTION(output, "a", {{.*}}, ::symreal::symreal_extents(2), a[(0)+symreal_i[0]]) SYMREAL_OUTPUTS_END REAL_WRITTEN({{.*}}, y[0]) = x;
void scale(double x, double *y, double a[2]) { y[0] = x; a[1] = x; }

double use(Arm &arm, double *q) { return arm.torque(q, 1); }
