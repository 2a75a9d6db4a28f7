// Resolved-rate control of a redundant seven-joint arm: the joint velocities that move the tool with a wanted velocity,
// by damped least squares, with the joints weighted by their inverse inertia.
#include <Eigen/Dense>

#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct Joint {
  Vector3d offset; // in the frame of the joint before
  Vector3d axis;
};

class Arm {
public:
  Arm(std::vector<Joint> joints, Vector3d const &tool) : joints_(std::move(joints)), tool_(tool) {}

  Eigen::Index size() const { return static_cast<Eigen::Index>(joints_.size()); }

  // Poses of all joints in the base, and of the tool.
  std::vector<Isometry3d> poses(VectorXd const &q) const {
    std::vector<Isometry3d> result;
    Isometry3d pose = Isometry3d::Identity();
    for (Eigen::Index i = 0; i < size(); ++i) {
      auto const &[offset, axis] = joints_[static_cast<std::size_t>(i)];
      pose = pose * Eigen::Translation3d(offset) * Eigen::AngleAxisd(q[i], axis);
      result.push_back(pose);
    }
    result.push_back(pose * Eigen::Translation3d(tool_));
    return result;
  }

  // Velocity of the tool's origin for unit velocities of the joints.
  Matrix3Xd jacobian(std::vector<Isometry3d> const &poses) const {
    Matrix3Xd J(3, size());
    Vector3d const tip = poses.back().translation();
    auto const column = [&](std::size_t i) -> Vector3d {
      Vector3d const axis = poses[i].linear() * joints_[i].axis;
      return axis.cross(tip - poses[i].translation());
    };
    for (Eigen::Index i = 0; i < size(); ++i) J.col(i) = column(static_cast<std::size_t>(i));
    return J;
  }

private:
  std::vector<Joint> joints_;
  Vector3d tool_;
};

static Arm seven_joint_arm() {
  Vector3d const x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  return Arm({{{0.0, 0.0, 0.34}, z},
              {{0.0, 0.0, 0.0}, y},
              {{0.0, 0.0, 0.2}, z},
              {{0.02, 0.0, 0.2}, -y},
              {{-0.02, 0.0, 0.2}, z},
              {{0.0, 0.0, 0.2}, y},
              {{0.088, 0.0, 0.0}, x}},
             {0.05, 0.0, 0.126});
}

int main() {
  auto const arm = seven_joint_arm();
  VectorXd q(7), inertia(7);
  q << 0.2, 0.5, -0.3, 1.1, 0.4, -0.7, 0.25;
  inertia << 2.5, 2.2, 1.4, 1.1, 0.6, 0.4, 0.2;
  Vector3d velocity(0.1, -0.05, 0.2);
  double damping = 0.05;

#pragma symreal input(q, velocity) range(-2, 2) parameter(inertia, damping) constant(arm)
  auto const poses = arm.poses(q);
  Matrix3Xd const J = arm.jacobian(poses);
  VectorXd const weights = inertia.cwiseInverse();
  MatrixXd const weighted = weights.asDiagonal() * J.transpose();
  Matrix3d const mobility = J * weighted;
  Matrix3d const regular = mobility + damping * damping * Matrix3d::Identity();
  VectorXd qd = weighted * (regular.inverse() * velocity);
  Vector3d position = poses.back().translation();
  double manipulability = std::sqrt(mobility.determinant());
#pragma symreal output(qd, position, manipulability) generate("arm.c")

  for (Eigen::Index i = 0; i < qd.size(); ++i) std::printf("%.17g\n", qd[i]);
  std::printf("%.17g %.17g %.17g\n%.17g\n", position.x(), position.y(), position.z(), manipulability);
}
