// Eigen aligns a vector of four numbers, but not where it may not vectorise, as in the build of the rewritten program: the
// rewriter reads it as that build does. The text for a build of the user's own knows the alignment there.
// RUN: %symreal generate %s -o %t.c -- -I/usr/include/eigen3
// RUN: %symreal verify %s %t.c --samples=100 -- -I/usr/include/eigen3
// RUN: %symreal scan --compile %s -- -I/usr/include/eigen3
// RUN: %rewrite %s -- -I/usr/include/eigen3 | FileCheck %s
#include <Eigen/Core>

// CHECK: class Quaternion : public Eigen::Vector4<REAL>
// CHECK-SAME: sizeof(symreal_class) == 32 && alignof(symreal_class) == 16)
class Quaternion : public Eigen::Vector4d {
public:
  Quaternion(double x, double y, double z, double w) : Eigen::Vector4d(x, y, z, w) {}
};

#pragma symreal function input(x) output(return)
double scaled(double x) { return (x * Quaternion(1, 2, 3, 4)).norm(); }

int main() { return scaled(0.5) > 0 ? 0 : 1; }
