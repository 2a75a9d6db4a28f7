// Pinocchio's analytic derivatives on the robot of inputs/chain, as a contender: the function, then its Jacobian in q
// and qd.
#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>

#include "contender.h"
#include "pinocchio_robot.h"

#include <cstring>

namespace {

void write(Eigen::VectorXd const &value, Eigen::MatrixXd const &by_q, Eigen::MatrixXd const &by_qd, double *output) {
  for (int i = 0; i < n; i++) {
    output[i] = value[i];
    for (int j = 0; j < n; j++) {
      output[n + 2 * n * i + j] = by_q(i, j);
      output[n + 2 * n * i + n + j] = by_qd(i, j);
    }
  }
}

void rnea(double const *input, double *output) {
  pinocchio::computeRNEADerivatives(robot, data, part(input, 0), part(input, 1), part(input, 2));
  write(data.tau, data.dtau_dq, data.dtau_dv, output);
}

void aba(double const *input, double *output) {
  pinocchio::computeABADerivatives(robot, data, part(input, 0), part(input, 1), part(input, 2));
  write(data.ddq, data.ddq_dq, data.ddq_dv, output);
}

} // namespace

Evaluate contender(char const *kernel, int joints, char const *model) {
  make_robot(joints, model);
  return !std::strcmp(kernel, "rnea") ? rnea : aba;
}
