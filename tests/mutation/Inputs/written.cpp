#include <cstdio>
struct Model {
  double last;
};
#pragma symreal function input(x) output(return)
double kernel(Model *model, double x) {
  model->last = 3.0;
  return x * x;
}
int main() {
  Model *const model = new Model{1.0};
  std::printf("%g %g\n", kernel(model, 5.3), model->last);
}
