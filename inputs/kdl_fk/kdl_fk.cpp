// Forward kinematics of a six-joint arm with the frames of Orocos KDL. Only inline members of KDL are used: the product
// of two rotations, which stands in KDL's compiled library, is put together from what the headers have.
#include "arm.h"

#include <kdl/frames.hpp>

#include <cstdio>

static KDL::Rotation product(KDL::Rotation const &a, KDL::Rotation const &b) {
  return KDL::Rotation(a * b.UnitX(), a * b.UnitY(), a * b.UnitZ());
}

static KDL::Frame compose(KDL::Frame const &a, KDL::Frame const &b) {
  return KDL::Frame(product(a.M, b.M), a.M * b.p + a.p);
}

static KDL::Rotation joint_rotation(char axis, double q) {
  return axis == 'x' ? KDL::Rotation::RotX(q) : axis == 'y' ? KDL::Rotation::RotY(q) : KDL::Rotation::RotZ(q);
}

#pragma symreal function input(q[0:6]) output(pose.M.data[0:9], pose.p.data[0:3])
void forward_kinematics(double const *q, KDL::Frame &pose) {
  pose = KDL::Frame::Identity();
  for (int i = 0; i < 6; i++) {
    KDL::Frame const joint(joint_rotation(arm[i].axis, q[i]));
    KDL::Frame const tip(KDL::Rotation::RotX(arm[i].turn), KDL::Vector(arm[i].tip[0], arm[i].tip[1], arm[i].tip[2]));
    pose = compose(pose, compose(joint, tip));
  }
}

int main() {
  KDL::Frame pose;
  forward_kinematics(arm_q, pose);
  for (int i = 0; i < 9; i++) std::printf("%.17g\n", pose.M.data[i]);
  for (int i = 0; i < 3; i++) std::printf("%.17g\n", pose.p[i]);
}
