// Nothing of Symreal stands here.
#include <cmath>
#include <cstdio>

extern "C" double friction(double rate);

namespace arm {
struct Model {
  double m, L;
};

void torque(double const *q, double const *qd, int n, Model const &model, double *tau) {
  for (int i = 0; i < n; i++) tau[i] = model.m * model.L * std::sin(q[i]) + friction(qd[i]);
}

namespace {
double scaled(double x) { return 2 * x; }
double scaled(double x, int by) { return by * x; }
} // namespace
} // namespace arm

class Filter {
public:
  double step(double x);

private:
  double state_ = 0, gain_ = 0.5;
};

double Filter::step(double x) {
  state_ += gain_ * (x - state_);
  return state_;
}

int main() {
  double q[2] = {0.5, 1}, qd[2] = {1, 2}, tau[2];
  arm::torque(q, qd, 2, {1, 2}, tau);
  Filter filter;
  std::printf("%g %g %g %g\n", tau[0], filter.step(1), arm::scaled(1), arm::scaled(1, 2));
}
