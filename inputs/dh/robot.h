// Serial robots in modified Denavit-Hartenberg notation: frame i follows from frame i-1 by Rx(alpha) Tx(d) Rz(q) Tz(r).
#pragma once

#include "vec3.h"

#include <vector>

namespace dh {

struct Joint {
  double cos_alpha, sin_alpha; // exact for right angles
  double d, r;
};

struct Robot {
  std::vector<Joint> joints;
  Vec3 gravity;

  int size() const { return static_cast<int>(joints.size()); }
};

// Inertial parameters, ten for each link: mass, first moment (mx, my, mz) and the inertia about the origin of the
// link's frame (xx, xy, xz, yy, yz, zz).
struct Inertia {
  double mass;
  Vec3 moment;
  Mat3 tensor;
};

enum { INERTIA_SIZE = 10 };
Inertia unpack(double const *parameters);
void pack(double *parameters, double mass, Vec3 centre, double const inertia_about_centre[6]);

Robot rx90();
std::vector<double> rx90_parameters();
Robot planar(int n);
std::vector<double> planar_parameters(int n);

// The state that the example programs use.
std::vector<double> steps(int n, double first, double step);

void print(std::vector<double> const &values);

} // namespace dh
