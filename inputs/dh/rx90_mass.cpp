// The mass matrix of the RX90.
#include "dynamics.h"

#pragma symreal function input(q[0:6]) parameter(inertial[0:60]) output(M[0:6][0:6])
void rx90_mass(double const *inertial, double const *q, double M[6][6]) {
  dh::mass_matrix(dh::rx90(), inertial, q, &M[0][0]);
}

int main() {
  double M[6][6];
  rx90_mass(dh::rx90_parameters().data(), dh::steps(6, .3, .2).data(), M);
  for (auto const &row : M) dh::print(std::vector<double>(row, row + 6));
}
