// A value for an object is one for all of its numbers that a program can name; the others are as it is made.
// RUN: %symreal generate %s --kernel 'energy(body=0.5) -> return' -o %t.c 2>&1 | FileCheck %s
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c --kernel 'energy(body=0.5) -> return' 2>&1 | FileCheck %s --check-prefix=VERIFY
// RUN: FileCheck %s --check-prefix=HEADER < %t.h
// CHECK: kernel energy: 7 inputs, 0 parameters, 1 outputs
// VERIFY: return {{ *}}1 {{ *}}0 {{ *}}0
// HEADER: double mass;
#include <array>

struct Part {
  double mass = 1;
};
class Body : public Part {
public:
  std::array<double, 2> v{};
  double at[2][1] = {};
  double energy() const { return mass * (v[0] * v[0] + v[1] * v[1]) + gravity_ * height_ + at[0][0] - at[1][0]; }

private:
  double gravity_ = 9.81, height_ = 2;
};

double energy(Body const &body) { return body.energy(); }
