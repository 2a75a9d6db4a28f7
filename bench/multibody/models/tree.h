// Rigid bodies that revolute joints connect to a tree with a fixed base, and five algorithms on it. Vectors have three
// components; each body has a frame in its joint, and a joint turns about one of the frame's axes.
#pragma once

#include "vec3.h"

#include <string>

namespace tree {

using dh::Mat3;
using dh::Vec3;

constexpr int max_bodies = 1000;

struct Body {
  int parent;  // -1: the base
  Vec3 axis;   // of the joint: a unit vector
  Vec3 offset; // of the joint, in the parent's frame
  double mass;
  Vec3 moment;  // mass times centre of mass, in the body's frame
  Mat3 inertia; // about the frame's origin
};

struct Tree {
  int n, tips; // bodies, and those that have no child
  Vec3 gravity;
  Body body[max_bodies];
};

// planar, spatial: chains of n bodies; binary: body i hangs on body (i - 1) / 2; humanoid: 30 bodies, whatever n is.
Tree make_tree(std::string const &shape, int n);

// Rotation (tip to base, row by row) and position of each tip: 12 numbers a tip.
void forward_kinematics(Tree const &tree, double const *q, double *pose);

// One step of damped least squares that moves the last body's origin towards `target`.
void inverse_kinematics(Tree const &tree, double const *q, double const *target, double *q_next);

// tau(q, qd, qdd) by the recursive Newton-Euler algorithm.
void inverse_dynamics(Tree const &tree, double const *q, double const *qd, double const *qdd, double *tau);

// The joint-space inertia matrix, n by n, by the composite-rigid-body algorithm.
void mass_matrix(Tree const &tree, double const *q, double *H);

// qdd(q, qd, tau) by the articulated-body algorithm.
void forward_dynamics(Tree const &tree, double const *q, double const *qd, double const *tau, double *qdd);

// How the body's vectors turn into the parent's.
Mat3 joint_rotation(Body const &body, double q);

} // namespace tree
