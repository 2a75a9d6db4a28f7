#include "dynamics.h"

#include <cmath>

namespace dh {

namespace {

// Frame i in frame i-1: v in frame i is rotation * v + position in frame i-1.
struct Pose {
  Mat3 rotation;
  Vec3 position;
};

Pose pose(Joint const &joint, double q) {
  double const c = std::cos(q), s = std::sin(q), ca = joint.cos_alpha, sa = joint.sin_alpha;
  return {{{{c, -s, 0}, {ca * s, ca * c, -sa}, {sa * s, sa * c, ca}}}, {joint.d, -sa * joint.r, ca * joint.r}};
}

std::vector<Pose> poses(Robot const &robot, double const *q) {
  std::vector<Pose> result;
  for (int i = 0; i < robot.size(); i++) result.push_back(pose(robot.joints[i], q[i]));
  return result;
}

} // namespace

void newton_euler(Robot const &robot, double const *inertial, double const *q, double const *qd, double const *qdd,
                  double *tau) {
  int const n = robot.size();
  std::vector<Pose> const frames = poses(robot, q);
  std::vector<Vec3> forces(n), moments(n);

  Vec3 w = {0, 0, 0}, wd = {0, 0, 0}, a = -robot.gravity;
  for (int i = 0; i < n; i++) {
    Vec3 const p = frames[i].position;
    Mat3 const to_link = transpose(frames[i].rotation);
    a = to_link * (a + cross(wd, p) + cross(w, cross(w, p)));
    w = to_link * w;
    wd = to_link * wd + Vec3{w.y * qd[i], -w.x * qd[i], qdd[i]};
    w.z += qd[i];

    Inertia const link = unpack(inertial + i * INERTIA_SIZE);
    forces[i] = link.mass * a + cross(wd, link.moment) + cross(w, cross(w, link.moment));
    moments[i] = link.tensor * wd + cross(w, link.tensor * w) + cross(link.moment, a);
  }

  for (int i = n - 1; i >= 0; i--) {
    tau[i] = moments[i].z;
    if (i == 0) break;
    Vec3 const force = frames[i].rotation * forces[i];
    forces[i - 1] = forces[i - 1] + force;
    moments[i - 1] = moments[i - 1] + frames[i].rotation * moments[i] + cross(frames[i].position, force);
  }
}

void mass_matrix(Robot const &robot, double const *inertial, double const *q, double *M) {
  int const n = robot.size();
  std::vector<Pose> const frames = poses(robot, q);

  // All links from i outwards as one body.
  std::vector<Inertia> body(n);
  for (int i = 0; i < n; i++) body[i] = unpack(inertial + i * INERTIA_SIZE);
  for (int i = n - 1; i > 0; i--) {
    Mat3 const R = frames[i].rotation;
    Vec3 const p = frames[i].position;
    Vec3 const turned = R * body[i].moment;
    Vec3 const shifted = turned + body[i].mass * p;
    body[i - 1].mass += body[i].mass;
    body[i - 1].moment = body[i - 1].moment + shifted;
    body[i - 1].tensor = body[i - 1].tensor + R * body[i].tensor * transpose(R) +
                         (diagonal(dot(p, turned) + dot(p, shifted)) - outer(shifted, p) - outer(p, turned));
  }

  for (int i = 0; i < n; i++) {
    // Force and moment that accelerate that body about joint i.
    Vec3 force = cross({0, 0, 1}, body[i].moment);
    Vec3 moment = body[i].tensor * Vec3{0, 0, 1};
    M[i * n + i] = moment.z;
    for (int j = i; j > 0; j--) {
      force = frames[j].rotation * force;
      moment = frames[j].rotation * moment + cross(frames[j].position, force);
      M[i * n + j - 1] = M[(j - 1) * n + i] = moment.z;
    }
  }
}

void accelerations(Robot const &robot, double const *inertial, double const *q, double const *qd, double const *tau,
                   double *qdd) {
  int const n = robot.size();
  std::vector<double> const still(n, 0.0);
  std::vector<double> M(n * n), bias(n), L(n * n), D(n), y(n);
  mass_matrix(robot, inertial, q, M.data());
  newton_euler(robot, inertial, q, qd, still.data(), bias.data());

  // M = L D L^T, then three triangular solves.
  for (int i = 0; i < n; i++) {
    for (int j = 0; j <= i; j++) {
      double sum = M[i * n + j];
      for (int k = 0; k < j; k++) sum -= L[i * n + k] * D[k] * L[j * n + k];
      if (j < i)
        L[i * n + j] = sum / D[j];
      else
        D[i] = sum;
    }
  }
  for (int i = 0; i < n; i++) {
    y[i] = tau[i] - bias[i];
    for (int k = 0; k < i; k++) y[i] -= L[i * n + k] * y[k];
  }
  for (int i = n - 1; i >= 0; i--) {
    qdd[i] = y[i] / D[i];
    for (int k = i + 1; k < n; k++) qdd[i] -= L[k * n + i] * qdd[k];
  }
}

} // namespace dh
