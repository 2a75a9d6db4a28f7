// The robot of inputs/chain as Pinocchio has it, made once, as its manual says.
#pragma once

#include <pinocchio/multibody.hpp>

#include "model.h"

namespace {

pinocchio::Model robot;
pinocchio::Data data;
int n;

Eigen::Map<Eigen::VectorXd const> part(double const *input, int which) { return {input + which * n, n}; }

void make_robot(int joints, char const *model) {
  auto const vector = [](double const *v) { return Eigen::Vector3d(v[0], v[1], v[2]); };
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
}

} // namespace
