// What no other file can define is replaced in a copy of its own file, in which the body stays: functions of one source, those
// of a class, of a template. The program that has the copy prints the same, also where a guard fails or a baked value differs.
// DEFINE: %{name} =
// DEFINE: %{same} = %cc -c %{name}.c && %cxx -Wno-unknown-pragmas %{name}_wrapper.cpp %{name}.o -o swapped && ./swapped > printed && %cxx -Wno-unknown-pragmas %s -o original && ./original | diff - printed
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o . --wrapper --prefix=p --decisions=guard -- -DKERNEL=1 2>&1 | FileCheck %s
// CHECK: wrapper_copies.cpp:[[#]]:1: remark: the wrapper of 'gain' is a copy of its file, since it is static or in an unnamed namespace, so only its own file can call it: compile ./gain_wrapper.cpp in place of {{.*}}wrapper_copies.cpp [SYM096]
// REDEFINE: %{name} = gain
// RUN: cd %t && %{same} && FileCheck %s --check-prefix=COPY < gain_wrapper.cpp
// COPY: a copy of wrapper_copies.cpp, in which generated code stands before the body of (anonymous namespace)::gain.
// COPY: if ((long long)(steps) != 2ll)
// COPY: return symreal_output[0];
// COPY: #line [[#]]
// RUN: cd %t && %symreal verify %s gain.c --samples=50 --min-samples=5 -- -DKERNEL=1 2>&1 | FileCheck %s --check-prefix=VERIFY
// VERIFY: the wrapper was tried as well

// An inline method, an operator, a virtual function with an unnamed namespace's type, an instantiation of a template, and a
// constructor.
// REDEFINE: %{name} = scaled
// RUN: cd %t && %symreal generate %s -o scaled.c --wrapper --decisions=guard -- -DKERNEL=2 && %{same}
// REDEFINE: %{name} = operator
// RUN: cd %t && %symreal generate %s -o operator.c --wrapper -- -DKERNEL=3 && %{same}
// REDEFINE: %{name} = torque
// RUN: cd %t && %symreal generate %s -o torque.c --wrapper -- -DKERNEL=4 && %{same}
// REDEFINE: %{name} = mixed
// RUN: cd %t && %symreal generate %s -o mixed.c --wrapper -- -DKERNEL=5 && %{same}
// REDEFINE: %{name} = made
// RUN: cd %t && %symreal generate %s -o made.c --wrapper -- -DKERNEL=6 && %{same}
#include <cstdio>

#ifndef KERNEL
#define KERNEL 0
#endif

namespace {
#if KERNEL == 1
#pragma symreal function input(x) constant(steps) output(return)
#endif
double gain(double x, int steps) {
  if (x < 0) return -x;
  for (int k = 0; k < steps; ++k) x = x * x + k;
  return x;
}

struct Vector {
  double x, y;
#if KERNEL == 2
#pragma symreal function input(x, y, factor) output(return)
#endif
  double scaled(double factor) const { return factor > 0 ? factor * x + y : y; }
#if KERNEL == 3
#pragma symreal function input(x, y, other.x, other.y) output(return)
#endif
  Vector operator+(Vector const &other) const {
    Vector sum;
    sum.x = x + other.x;
    sum.y = y + other.y;
    return sum;
  }
};

struct Motor {
  virtual ~Motor() = default;
  virtual double torque(double current) const = 0;
};
struct Linear : Motor {
  double k = 2;
#if KERNEL == 4
#pragma symreal function input(current) parameter(k) output(return)
#endif
  double torque(double current) const override { return losses() * k * current; }
  virtual double losses() const { return 0.5; }
};
struct Worn : Linear {
  double losses() const override { return 0.25; }
};

#if KERNEL == 5
#pragma symreal function input(x, y) output(return)
#endif
template <class T, int n> T mixed(T x, T y) {
  T sum = 0;
  for (int k = 0; k < n; ++k) sum += x * y + k;
  return sum;
}

struct Made {
  double a, b;
#if KERNEL == 6
#pragma symreal function input(x) output(a, b)
#endif
  explicit Made(double x) {
    a = x * x;
    b = a + 1;
  }
};
} // namespace

int main() {
  std::printf("%g %g %g\n", gain(1.5, 2), gain(1.5, 4), gain(-2, 2));
  Vector const v = {1, 2}, w = {0.5, 0.25};
  std::printf("%g %g %g %g\n", v.scaled(2), v.scaled(-1), (v + w).x, (v + w).y);
  Linear const linear;
  Worn const worn;
  Motor const *motors[] = {&linear, &worn};
  for (Motor const *motor : motors) std::printf("%g\n", motor->torque(3));
  std::printf("%g %g\n", mixed<double, 2>(1.5, 2.5), mixed<double, 3>(1.5, 2.5));
  Made const made(3);
  std::printf("%g %g\n", made.a, made.b);
}
