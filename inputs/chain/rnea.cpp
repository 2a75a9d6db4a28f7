// Inverse dynamics of an N-link chain: rnea [N [model.csv]]
#include "example.h"

#pragma symreal function input(q[0:model.size()], qd[0:model.size()], qdd[0:model.size()]) constant(model) output(tau[0:model.size()])
void rnea(chain::Model const &model, double const *q, double const *qd, double const *qdd, double *tau) {
  chain::inverse_dynamics(model, q, qd, qdd, tau);
}

int main(int argc, char **argv) {
  chain::Model const model = chain::example_model(argc, argv);
  int const n = model.size();
  std::vector<double> const q = chain::example_q(n), qd = chain::example_qd(n), qdd = chain::example_qdd_or_tau(n);
  std::vector<double> tau(n);
  rnea(model, q.data(), qd.data(), qdd.data(), tau.data());
  chain::print(tau);
}
