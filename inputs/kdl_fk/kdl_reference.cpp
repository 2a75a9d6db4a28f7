// What KDL's compiled solver says about the same arm.
#include "arm.h"

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>

#include <cstdio>

int main() {
  KDL::Chain chain;
  for (ArmJoint const &joint : arm) {
    KDL::Joint::JointType const type = joint.axis == 'x'   ? KDL::Joint::RotX
                                       : joint.axis == 'y' ? KDL::Joint::RotY
                                                           : KDL::Joint::RotZ;
    KDL::Vector const tip(joint.tip[0], joint.tip[1], joint.tip[2]);
    chain.addSegment(KDL::Segment(KDL::Joint(type), KDL::Frame(KDL::Rotation::RotX(joint.turn), tip)));
  }
  KDL::JntArray q(6);
  for (unsigned i = 0; i < 6; i++) q(i) = arm_q[i];
  KDL::Frame pose;
  if (KDL::ChainFkSolverPos_recursive(chain).JntToCart(q, pose) < 0) return 1;
  for (int i = 0; i < 9; i++) std::printf("%.17g\n", pose.M.data[i]);
  for (int i = 0; i < 3; i++) std::printf("%.17g\n", pose.p[i]);
}
