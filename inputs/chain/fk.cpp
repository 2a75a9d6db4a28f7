// Forward kinematics of an N-link chain: fk [N [model.csv]]
#include "example.h"

#pragma symreal function input(q[0:model.size()]) constant(model) output(pose[0:12])
void fk(chain::Model const &model, double const *q, double *pose) { chain::forward_kinematics(model, q, pose); }

int main(int argc, char **argv) {
  chain::Model const model = chain::example_model(argc, argv);
  int const n = model.size();
  std::vector<double> const q = chain::example_q(n);
  std::vector<double> pose(12);
  fk(model, q.data(), pose.data());
  chain::print(pose);
}
