// Pinocchio's analytic derivatives on the robot of inputs/chain, as a contender: the function, then its Jacobian in q
// and qd.
#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/multibody.hpp>

#include "contender.h"

#include "model.h"

#include <cstring>

namespace {

pinocchio::Model robot;
pinocchio::Data data;
int n;

Eigen::Map<Eigen::VectorXd const> part(double const *input, int which) { return {input + which * n, n}; }
Eigen::Vector3d vector(double const *v) { return {v[0], v[1], v[2]}; }

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
  n = joints;
  pinocchio::JointIndex parent = 0;
  for (chain::Link const &link : chain::read_links(model, n)) {
    pinocchio::SE3 const place(Eigen::Matrix3d::Identity(), vector(link.offset));
    std::string const name = "joint " + std::to_string(robot.njoints);
    parent = link.axis == 0   ? robot.addJoint(parent, pinocchio::JointModelRX(), place, name)
             : link.axis == 1 ? robot.addJoint(parent, pinocchio::JointModelRY(), place, name)
                              : robot.addJoint(parent, pinocchio::JointModelRZ(), place, name);
    Eigen::Matrix3d const inertia = Eigen::Map<Eigen::Matrix3d const>(&link.inertia[0][0]); // symmetric
    robot.appendBodyToJoint(parent, pinocchio::Inertia(link.mass, vector(link.centre), inertia));
  }
  robot.gravity.linear(Eigen::Vector3d(0, 0, -9.80665));
  data = pinocchio::Data(robot);
  return !std::strcmp(kernel, "rnea") ? rnea : aba;
}
