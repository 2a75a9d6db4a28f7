// The mass matrix of an N-link chain: crba [N [model.csv]]
#include "example.h"

#pragma symreal function input(q[0:model.size()]) constant(model) output(H[0:model.size() * model.size()])
void crba(chain::Model const &model, double const *q, double *H) { chain::mass_matrix(model, q, H); }

int main(int argc, char **argv) {
  chain::Model const model = chain::example_model(argc, argv);
  int const n = model.size();
  std::vector<double> const q = chain::example_q(n);
  std::vector<double> H(n * n);
  crba(model, q.data(), H.data());
  chain::print(H);
}
