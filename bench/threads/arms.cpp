// Forward dynamics of ARMS arms of N links that have nothing to do with each other: arms N [model.csv]
#include "example.h"

#ifndef ARMS
#define ARMS 2
#endif

// clang-format off
#pragma symreal function input(q[0:n], qd[0:n], tau[0:n]) constant(model, n) output(qdd[0:n])
// clang-format on
void arms(chain::Model const &model, int n, double const *q, double const *qd, double const *tau, double *qdd) {
  for (int at = 0; at < n; at += model.size()) chain::forward_dynamics(model, q + at, qd + at, tau + at, qdd + at);
}

int main(int argc, char **argv) {
  chain::Model const model = chain::example_model(argc, argv);
  int const n = ARMS * model.size();
  std::vector<double> const q = chain::example_q(n), qd = chain::example_qd(n), tau = chain::example_qdd_or_tau(n);
  std::vector<double> qdd(n);
  arms(model, n, q.data(), qd.data(), tau.data(), qdd.data());
  chain::print(qdd);
}
