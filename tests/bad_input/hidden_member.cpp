// Members that are read and named in no pragma: through this, a reference, a pointer, by element, as a copy.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cmath>
#include <cstdio>

struct Joint {
  double damping, limits[2];
};

class Motor {
public:
  Motor(double gain, Joint joint) : gain_(gain), joint_(joint) {}
  double torque(double x) const { return gain_ * std::sin(x); }
  Joint joint() const { return joint_; }

private:
  double gain_;
  Joint joint_;
};

double range(double const *limits) {
  double sum = 0;
  for (int i = 0; i < 2; i++) sum += limits[i];
  return sum;
}

#pragma symreal function input(x) output(return)
double drive(Motor const &motor, Joint *other, Joint const &third, double x) {
  double const y = motor.torque(x) + motor.joint().damping;
  return y * other->damping + range(third.limits);
}

int main() {
  Motor const motor(2.5, {0.25, {-1.0, 3.0}});
  Joint joint = {0.125, {-2.0, 2.0}};
  std::printf("%g\n", drive(motor, &joint, joint, 0.5));
}

// CHECK: hidden_member.cpp:15:42: error: kernel 'drive' reads 'gain_' (2.5), which is neither input nor parameter [SYM017]
// CHECK: hidden_member.cpp:31:{{[0-9]+}}: note: called from drive(Motor const&, Joint*, Joint const&, double)
// CHECK: help:
// CHECK: hidden_member.cpp:16:32: error: kernel 'drive' reads 'joint_' (0.25, -1, 3), which are neither input
// CHECK: hidden_member.cpp:25:38: error: kernel 'drive' reads 'limits[i]' (-2, 2), which are neither input
// CHECK: hidden_member.cpp:32:{{[0-9]+}}: note: called from drive(
// CHECK: hidden_member.cpp:32:14: error: kernel 'drive' reads 'other->damping' (0.125), which is neither input nor parameter [SYM017]
// CHECK-NOT: SYM017]
