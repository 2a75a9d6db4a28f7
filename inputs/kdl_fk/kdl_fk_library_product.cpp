// As kdl_fk.cpp, with KDL's own product of frames. It calls the product of two rotations, which no header defines: the
// compiled library knows nothing of another number type.
#include "arm.h"

#include <kdl/frames.hpp>

#include <cstdio>

#pragma symreal function input(q[0:6]) output(pose.M.data[0:9], pose.p.data[0:3])
void forward_kinematics(double const *q, KDL::Frame &pose) {
  pose = KDL::Frame::Identity();
  for (int i = 0; i < 6; i++) {
    KDL::Rotation const turn = arm[i].axis == 'x'   ? KDL::Rotation::RotX(q[i])
                               : arm[i].axis == 'y' ? KDL::Rotation::RotY(q[i])
                                                    : KDL::Rotation::RotZ(q[i]);
    KDL::Frame const tip(KDL::Rotation::RotX(arm[i].turn), KDL::Vector(arm[i].tip[0], arm[i].tip[1], arm[i].tip[2]));
    pose = pose * (KDL::Frame(turn) * tip);
  }
}

int main() {
  KDL::Frame pose;
  forward_kinematics(arm_q, pose);
  for (int i = 0; i < 9; i++) std::printf("%.17g\n", pose.M.data[i]);
  for (int i = 0; i < 3; i++) std::printf("%.17g\n", pose.p[i]);
}
