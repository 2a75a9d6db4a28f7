#include "tree.h"

namespace tree {

namespace {

struct Pose {
  Mat3 rotation; // to the base
  Vec3 position;
};

Pose next(Pose const &parent, Body const &body, double q) {
  return {parent.rotation * joint_rotation(body, q), parent.position + parent.rotation * body.offset};
}

Pose base() { return {dh::diagonal(1), {0, 0, 0}}; }

} // namespace

void forward_kinematics(Tree const &tree, double const *q, double *pose) {
  Pose frames[max_bodies];
  bool has_child[max_bodies] = {};
  for (int i = 0; i < tree.n; i++) {
    int const parent = tree.body[i].parent;
    frames[i] = next(parent < 0 ? base() : frames[parent], tree.body[i], q[i]);
    if (parent >= 0) has_child[parent] = true;
  }
  for (int i = 0; i < tree.n; i++) {
    if (has_child[i]) continue;
    for (Vec3 const &row :
         {frames[i].rotation.row[0], frames[i].rotation.row[1], frames[i].rotation.row[2], frames[i].position}) {
      *pose++ = row.x;
      *pose++ = row.y;
      *pose++ = row.z;
    }
  }
}

void inverse_kinematics(Tree const &tree, double const *q, double const *target, double *q_next) {
  int path[max_bodies], length = 0; // from the last body to the base
  for (int i = tree.n - 1; i >= 0; i = tree.body[i].parent) path[length++] = i;
  Pose frames[max_bodies];
  frames[0] = base();
  for (int k = length - 1; k >= 0; k--)
    frames[k] = next(k == length - 1 ? base() : frames[k + 1], tree.body[path[k]], q[path[k]]);
  Vec3 const tip = frames[0].position;
  Vec3 const error = Vec3{target[0], target[1], target[2]} - tip;

  // (J J^T + damping^2) y = error, dq = J^T y
  Mat3 A = dh::diagonal(0.01);
  Vec3 column[max_bodies];
  for (int k = 0; k < length; k++) {
    column[k] = cross(frames[k].rotation * tree.body[path[k]].axis, tip - frames[k].position);
    A = A + outer(column[k], column[k]);
  }
  Vec3 const yz = cross(A.row[1], A.row[2]), zx = cross(A.row[2], A.row[0]), xy = cross(A.row[0], A.row[1]);
  Vec3 const y = (1 / dot(A.row[0], yz)) * (error.x * yz + error.y * zx + error.z * xy);
  for (int i = 0; i < tree.n; i++) q_next[i] = q[i];
  for (int k = 0; k < length; k++) q_next[path[k]] += dot(column[k], y);
}

} // namespace tree
