// Classes are annotated as a whole: private members, those of bases, containers and complex numbers among them, and
// what `*this` and containers of such classes hold.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/ --kernel advance 2>&1 | FileCheck %s --check-prefix=LIST
// RUN: FileCheck %s --check-prefix=HEADER < %t/advance.h
// RUN: %symreal generate %s -o %t/ --kernel total
// RUN: FileCheck %s --check-prefix=TOTAL < %t/total.h
// RUN: %symreal verify %s %t/advance.c %t/total.c --samples=100 2>&1 | FileCheck %s --check-prefix=SAME
#include <array>
#include <complex>
#include <cstdio>
#include <vector>

namespace model {

class Base {
protected:
  double mass_ = 2;
  int count_ = 3;
};
struct Axis {
  double x, y, z;
};
class Arm : public Base {
public:
  Arm(double first) : angles_{first, 2 * first}, gains_(3, first) {}
#pragma symreal function input(*this, axis) output(*this)
  void advance(Axis const &axis) {
    angles_[0] += axis.x * mass_ * count_;
    angles_[1] *= axis.y + gains_[2];
    phase_ *= std::complex<double>(0, 1);
    axis_.z = axis.z;
    gains_[0] = angles_[0];
  }
  double angle(int k) const { return angles_[k]; }

private:
  std::array<double, 2> angles_;
  std::vector<double> gains_;
  std::complex<double> phase_{1, 2};
  Axis axis_{7, 8, 9};
};

#pragma symreal function input(axes, arms) output(return)
double total(std::vector<Axis> const &axes, std::array<Arm, 2> const &arms) {
  double sum = 0;
  for (Axis const &axis : axes) sum += axis.x * axis.y - axis.z;
  for (Arm const &arm : arms) sum -= arm.angle(0) * arm.angle(1);
  return sum;
}

} // namespace model

int main() {
  std::array<model::Arm, 2> arms{model::Arm(0.5), model::Arm(1.5)};
  arms[0].advance({1, 2, 3});
  std::printf("%g %g\n", arms[0].angle(1), total({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, arms));
}

// LIST: kernel advance: 14 inputs, 0 parameters, 11 outputs
// LIST: baked in {{.*}}count_ = 3
// HEADER: typedef struct input_values {
// HEADER-NEXT:   struct {
// HEADER-NEXT:     double mass_;
// HEADER-NEXT:     double angles_[2];
// HEADER-NEXT:     double gains_[3];
// HEADER-NEXT:     double phase_[2];
// HEADER-NEXT:     struct {
// HEADER-NEXT:       double x;
// HEADER-NEXT:       double y;
// HEADER-NEXT:       double z;
// HEADER-NEXT:     } axis_;
// HEADER-NEXT:   } value_this;
// TOTAL:   struct {
// TOTAL-NEXT:     double x;
// TOTAL-NEXT:     double y;
// TOTAL-NEXT:     double z;
// TOTAL-NEXT:   } axes[3];
// TOTAL:   } arms[2];
// SAME: kernel advance, mode finite: 100 samples
// SAME: {{^}}  {{.*}} 11 {{ *}}0 {{ *}}0
// SAME: kernel total, mode finite: 100 samples
// SAME: value_return {{ *}}1 {{ *}}0 {{ *}}0
