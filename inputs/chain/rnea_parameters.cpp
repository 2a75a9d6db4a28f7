// Inverse dynamics of an N-link chain, masses and inertias as parameters: rnea_parameters [N [model.csv]]
#include "example.h"

#pragma symreal function input(q[0:n], qd[0:n], qdd[0:n]) parameter(inertial[0:10 * n]) constant(links[0:n]) output(tau[0:n])
void rnea(chain::Link const *links, int n, double const *inertial, double const *q, double const *qd, double const *qdd,
          double *tau) {
  chain::Model model(std::vector<chain::Link>(links, links + n));
  model.set_parameters(inertial);
  chain::inverse_dynamics(model, q, qd, qdd, tau);
}

int main(int argc, char **argv) {
  chain::Model const model = chain::example_model(argc, argv);
  int const n = model.size();
  std::vector<double> const q = chain::example_q(n), qd = chain::example_qd(n), qdd = chain::example_qdd_or_tau(n);
  std::vector<double> const inertial = model.parameters();
  std::vector<double> tau(n);
  rnea(model.links().data(), n, inertial.data(), q.data(), qd.data(), qdd.data(), tau.data());
  chain::print(tau);
}
