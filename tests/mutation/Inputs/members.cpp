#include <cstdio>
#include <vector>
class Model {
public:
  double value(double x) const { return gain_ * x + weights_[1]; }

private:
  double gain_ = 2.5;
  std::vector<double> weights_{1.0, 2.0};
};
#pragma symreal function input(x) constant(model) output(return)
double kernel(Model const &model, double x) { return model.value(x); }
int main() {
  Model const model;
  std::printf("%g\n", kernel(model, 5.3));
}
