#include "tree.h"

#include <cmath>

namespace tree {

namespace {

Vec3 unit(int k) { return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; }

// Torso, neck, two arms of seven joints, two legs of six.
int const humanoid_parent[30] = {-1, 0,  1,  2,  1,  4,  5,  6,  7,  8,  9,  1,  11, 12, 13,
                                 14, 15, 16, -1, 18, 19, 20, 21, 22, -1, 24, 25, 26, 27, 28};

// `about_centre` moved to the frame's origin.
Mat3 about_origin(Mat3 const &about_centre, double mass, Vec3 c) {
  return about_centre + dh::diagonal(mass * dot(c, c)) - outer(mass * c, c);
}

} // namespace

Tree make_tree(std::string const &shape, int n) {
  Tree tree = {};
  bool const planar = shape == "planar";
  tree.n = shape == "humanoid" ? 30 : n;
  tree.gravity = planar ? Vec3{0, -9.81, 0} : Vec3{0, 0, -9.81};
  bool has_child[max_bodies] = {};
  for (int i = 0; i < tree.n; i++) {
    Body &body = tree.body[i];
    double const a = 0.01 * (i % 5), b = 0.01 * (i % 3);
    body.parent = shape == "binary" ? (i + 1) / 2 - 1 : shape == "humanoid" ? humanoid_parent[i] : i - 1;
    if (body.parent >= 0) has_child[body.parent] = true;
    body.axis = unit(planar ? 2 : i % 3);
    body.mass = 1.1 + a;
    Vec3 centre = {0.15 + b, 0, 0};
    Mat3 inertia = dh::diagonal(0.02 + a);
    if (planar) {
      body.offset = {i == 0 ? 0.0 : 0.3 + a, 0, 0};
    } else {
      body.offset = {0.05 + a, -0.02 - b, 0.3};
      centre = {0.11 + b, 0.07 - a, 0.05 + b};
      inertia = {{{0.5 + a, 0.02, -0.03}, {0.02, 0.6 + b, 0.015}, {-0.03, 0.015, 0.7 + a}}};
    }
    body.moment = body.mass * centre;
    body.inertia = about_origin(inertia, body.mass, centre);
  }
  for (int i = 0; i < tree.n; i++) tree.tips += has_child[i] ? 0 : 1;
  return tree;
}

// Joints turn about an axis of the frame, so one of three matrices does.
Mat3 joint_rotation(Body const &body, double q) {
  double const c = std::cos(q), s = std::sin(q);
  if (body.axis.x != 0) return {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
  if (body.axis.y != 0) return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
  return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
}

} // namespace tree
