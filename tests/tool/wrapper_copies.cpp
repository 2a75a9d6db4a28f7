// What no other file can define is replaced in a copy of its own file, in which the body stays: functions of one source, those
// of a class, of a template. They share the copy. The program that has it prints the same, also where a guard fails or a baked
// value differs.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o . --wrapper --prefix=p --decisions=guard 2>&1 | FileCheck %s
// CHECK: wrapper_copies.cpp:[[#]]:1: remark: the wrapper of 'gain' is a copy of its file, since it is static or in an unnamed namespace, so only its own file can call it: compile ./gain_wrapper.cpp in place of {{.*}}wrapper_copies.cpp [SYM096]
// CHECK: the wrapper of 'Made' is a copy of its file, since {{.*}}: compile ./gain_wrapper.cpp in place of {{.*}}wrapper_copies.cpp [SYM096]
// RUN: cd %t && %cxx -Wno-unknown-pragmas %s -o original && ./original > expected
// RUN: cd %t && %cc -c gain.c scaled.c operator+.c torque.c mixed.c Made.c && %cxx -Wno-unknown-pragmas gain_wrapper.cpp *.o -o swapped && ./swapped | diff expected -
// RUN: FileCheck %s --check-prefix=COPY < %t/gain_wrapper.cpp
// COPY: a copy of wrapper_copies.cpp, in which generated code stands before the bodies of (anonymous namespace)::gain, {{.*}}::Made. */
// COPY: if ((long long)(steps) != 2ll)
// COPY: p_gain_compute(symreal_input
// COPY: return symreal_output[0];
// COPY: #line [[#]]
// RUN: cd %t && %symreal verify %s gain.c operator+.c --samples=50 --min-samples=5 2>&1 | FileCheck %s --check-prefix=VERIFY
// VERIFY: the wrapper was tried as well
// VERIFY: the wrapper was tried as well

// One alone, of a class that inherits, is replaced by itself.
// RUN: cd %t && %symreal generate %s --kernel=torque -o alone.c --wrapper --prefix=p && FileCheck %s --check-prefix=ALONE < %t/alone_wrapper.cpp
// ALONE: before the body of (anonymous namespace)::Linear::torque.
// RUN: cd %t && %cc -c alone.c && %cxx -Wno-unknown-pragmas alone_wrapper.cpp alone.o -o swapped && ./swapped | diff expected -
#include <cstdio>

namespace {
#pragma symreal function input(x) constant(steps) output(return)
double gain(double x, int steps) {
  if (x < 0) return -x;
  for (int k = 0; k < steps; ++k) x = x * x + k;
  return x;
}

struct Vector {
  double x, y;
#pragma symreal function input(x, y, factor) output(return)
  double scaled(double factor) const { return factor > 0 ? factor * x + y : y; }
#pragma symreal function input(x, y, other.x, other.y) output(return)
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
#pragma symreal function input(current) parameter(k) output(return)
  double torque(double current) const override { return losses() * k * current; }
  virtual double losses() const { return 0.5; }
};
struct Worn : Linear {
  double losses() const override { return 0.25; }
};

#pragma symreal function input(x, y) output(return)
template <class T, int n> T mixed(T x, T y) {
  T sum = 0;
  for (int k = 0; k < n; ++k) sum += x * y + k;
  return sum;
}

struct Made {
  double a, b;
#pragma symreal function input(x) output(a, b)
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
