// A six-joint arm: each joint turns about an axis of its frame; `tip` leads from the joint's frame to the next joint's.
#pragma once

struct ArmJoint {
  char axis;
  double turn;   // about x, of the tip
  double tip[3]; // metres
};

static ArmJoint const arm[6] = {
    {'z', 0.0, {0.0, 0.0, 0.15}},   {'y', 0.0, {0.24, 0.0, 0.12}}, {'y', 0.1, {0.21, -0.09, 0.0}},
    {'x', -0.2, {0.0, 0.09, 0.03}}, {'z', 0.0, {0.0, 0.0, 0.09}},  {'x', 0.05, {0.08, 0.01, 0.0}},
};

static double const arm_q[6] = {0.3, -0.5, 0.7, 0.2, -0.4, 0.6};
