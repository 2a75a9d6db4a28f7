// Inverse dynamics of the RX90, a six-joint industrial arm.
#include "dynamics.h"

#pragma symreal function input(q[0:6], qd[0:6], qdd[0:6]) parameter(inertial[0:60]) output(tau[0:6])
void rx90_inverse(double const *inertial, double const *q, double const *qd, double const *qdd, double *tau) {
  dh::newton_euler(dh::rx90(), inertial, q, qd, qdd, tau);
}

int main() {
  std::vector<double> const q = dh::steps(6, .3, .2), qd = dh::steps(6, .5, -.1), qdd = dh::steps(6, -.4, .3);
  std::vector<double> tau(6);
  rx90_inverse(dh::rx90_parameters().data(), q.data(), qd.data(), qdd.data(), tau.data());
  dh::print(tau);
}
