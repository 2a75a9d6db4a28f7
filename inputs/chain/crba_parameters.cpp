// The mass matrix of an N-link chain, masses and inertias as parameters: crba_parameters [N [model.csv]]
#include "example.h"

#pragma symreal function input(q[0:n]) parameter(inertial[0:10 * n]) constant(links[0:n]) output(H[0:n * n])
void crba(chain::Link const *links, int n, double const *inertial, double const *q, double *H) {
  chain::Model model(std::vector<chain::Link>(links, links + n));
  model.set_parameters(inertial);
  chain::mass_matrix(model, q, H);
}

int main(int argc, char **argv) {
  chain::Model const model = chain::example_model(argc, argv);
  int const n = model.size();
  std::vector<double> const q = chain::example_q(n);
  std::vector<double> const inertial = model.parameters();
  std::vector<double> H(n * n);
  crba(model.links().data(), n, inertial.data(), q.data(), H.data());
  chain::print(H);
}
