// Pinocchio's own algorithms on the same robot, called as its manual says.
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include "contender.h"
#include "pinocchio_robot.h"

#include <cstring>

namespace {

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
  make_robot(joints, model);
  return !std::strcmp(kernel, "fk")     ? fk
         : !std::strcmp(kernel, "rnea") ? rnea
         : !std::strcmp(kernel, "crba") ? crba
                                        : aba;
}
