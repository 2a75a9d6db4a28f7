// Forward dynamics of the RX90.
#include "dynamics.h"

#pragma symreal function input(q[0:6], qd[0:6], tau[0:6]) parameter(inertial[0:60]) output(qdd[0:6])
void rx90_forward(double const *inertial, double const *q, double const *qd, double const *tau, double *qdd) {
  dh::accelerations(dh::rx90(), inertial, q, qd, tau, qdd);
}

int main() {
  std::vector<double> const q = dh::steps(6, .3, .2), qd = dh::steps(6, .5, -.1), tau = dh::steps(6, 1, .5);
  std::vector<double> qdd(6);
  rx90_forward(dh::rx90_parameters().data(), q.data(), qd.data(), tau.data(), qdd.data());
  dh::print(qdd);
}
