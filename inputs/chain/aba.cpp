// Forward dynamics of an N-link chain: aba [N [model.csv]]
#include "example.h"

#pragma symreal function input(q[0:model.size()], qd[0:model.size()], tau[0:model.size()]) constant(model) output(qdd[0:model.size()])
void aba(chain::Model const &model, double const *q, double const *qd, double const *tau, double *qdd) {
  chain::forward_dynamics(model, q, qd, tau, qdd);
}

int main(int argc, char **argv) {
  chain::Model const model = chain::example_model(argc, argv);
  int const n = model.size();
  std::vector<double> const q = chain::example_q(n), qd = chain::example_qd(n), tau = chain::example_qdd_or_tau(n);
  std::vector<double> qdd(n);
  aba(model, q.data(), qd.data(), tau.data(), qdd.data());
  chain::print(qdd);
}
