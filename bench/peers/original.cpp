// The functions of inputs/chain as a contender: linked with algorithms.cpp or with careful.cpp.
#include "contender.h"

#include "algorithms.h"

#include <cstring>

namespace {

chain::Model const *robot;
int n;

void fk(double const *in, double *out) { chain::forward_kinematics(*robot, in, out); }
void rnea(double const *in, double *out) { chain::inverse_dynamics(*robot, in, in + n, in + 2 * n, out); }
void crba(double const *in, double *out) { chain::mass_matrix(*robot, in, out); }
void aba(double const *in, double *out) { chain::forward_dynamics(*robot, in, in + n, in + 2 * n, out); }

} // namespace

Evaluate contender(char const *kernel, int joints, char const *model) {
  n = joints;
  robot = new chain::Model(chain::read_links(model, joints));
  return !std::strcmp(kernel, "fk")     ? fk
         : !std::strcmp(kernel, "rnea") ? rnea
         : !std::strcmp(kernel, "crba") ? crba
                                        : aba;
}
