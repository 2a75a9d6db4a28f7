// Inverse and forward dynamics of a planar robot: planar [number of joints]. Two kernels in one program.
#include "dynamics.h"

#include <cstdlib>

#pragma symreal function input(q[0:n], qd[0:n], qdd[0:n]) parameter(inertial[0:10 * n]) output(tau[0:n])
void planar_inverse(int n, double const *inertial, double const *q, double const *qd, double const *qdd, double *tau) {
  dh::newton_euler(dh::planar(n), inertial, q, qd, qdd, tau);
}

#pragma symreal function input(q[0:n], qd[0:n], tau[0:n]) parameter(inertial[0:10 * n]) output(qdd[0:n])
void planar_forward(int n, double const *inertial, double const *q, double const *qd, double const *tau, double *qdd) {
  dh::accelerations(dh::planar(n), inertial, q, qd, tau, qdd);
}

int main(int argc, char **argv) {
  int const n = argc > 1 ? std::atoi(argv[1]) : 3;
  std::vector<double> const q = dh::steps(n, .3, .2), qd = dh::steps(n, .5, -.1);
  std::vector<double> const inertial = dh::planar_parameters(n);
  std::vector<double> result(n);
  planar_inverse(n, inertial.data(), q.data(), qd.data(), dh::steps(n, -.4, .3).data(), result.data());
  dh::print(result);
  planar_forward(n, inertial.data(), q.data(), qd.data(), dh::steps(n, 1, .5).data(), result.data());
  dh::print(result);
}
