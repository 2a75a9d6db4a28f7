// Pinocchio's own algorithms on the same robot, called as its manual says: Model and Data are made once.
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/rnea.hpp>
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

void fk(double const *input, double *pose) {
  pinocchio::forwardKinematics(robot, data, part(input, 0));
  pinocchio::SE3 const &tip = data.oMi.back();
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) pose[3 * i + j] = tip.rotation()(i, j);
    pose[9 + i] = tip.translation()(i);
  }
}

void rnea(double const *input, double *tau) {
  pinocchio::rnea(robot, data, part(input, 0), part(input, 1), part(input, 2));
  for (int i = 0; i < n; i++) tau[i] = data.tau[i];
}

void crba(double const *input, double *H) {
  pinocchio::crba(robot, data, part(input, 0));
  for (int i = 0; i < n; i++)
    for (int j = i; j < n; j++) H[i * n + j] = H[j * n + i] = data.M(i, j);
}

void aba(double const *input, double *qdd) {
  pinocchio::aba(robot, data, part(input, 0), part(input, 1), part(input, 2));
  for (int i = 0; i < n; i++) qdd[i] = data.ddq[i];
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
  return !std::strcmp(kernel, "fk")     ? fk
         : !std::strcmp(kernel, "rnea") ? rnea
         : !std::strcmp(kernel, "crba") ? crba
                                        : aba;
}
