// Structures in region pragmas, in an array that the pragma takes a section of.
// RUN: %symreal generate %s -o %t.c
// RUN: FileCheck %s < %t.c --check-prefix=CODE
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
#include <cstdio>

class Joint {
public:
  Joint(double q, double a) : q_(q), link{a, 2 * a} {}
  double reach() const { return q_ * link.a - link.d; }

private:
  double q_;

public:
  struct {
    double a, d;
  } link;
};

int main() {
  Joint joints[3] = {{1, 2}, {3, 4}, {5, 6}};
  struct {
    double sum, product;
  } state = {0, 1};
#pragma symreal input(joints[1 : 2], state) range(-2, 2)
  for (Joint const &joint : joints) {
    state.sum += joint.reach();
    state.product *= joint.reach();
  }
#pragma symreal output(state) generate("state.c")
  std::printf("%g %g\n", state.sum, state.product);
}

// CODE: output[1] =
// SAME: state.{{.*}} 2 {{ *}}0 {{ *}}0
