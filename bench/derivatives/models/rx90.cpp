// Inverse dynamics of the RX90 of inputs/dh, whose inertial parameters are numbers. x: positions, rates; z:
// accelerations.
#include "dynamics.h"

void model(double const *x, double const *z, double *y) {
  std::vector<double> const inertial = dh::rx90_parameters();
  dh::newton_euler(dh::rx90(), inertial.data(), x, x + 6, z, y);
}
