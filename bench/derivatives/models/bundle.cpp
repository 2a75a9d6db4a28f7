// One reprojection of bundle adjustment, by the formulas of the automatic-differentiation benchmark of F. Srajer, Z.
// Kukelova and A. Fitzgibbon, "A benchmark of selected algorithmic differentiation tools on some problems in computer
// vision and machine learning", Optimization Methods and Software 33 (2018): rotation vector, centre, focal length,
// principal point and radial distortion of a camera; a point; its weight. x: these 15; z: where the point is seen.
// Written anew, without their branch for a rotation of exactly 0.
#include <cmath>

void model(double const *x, double const *z, double *y) {
  double const *turn = x, *centre = x + 3, *principal = x + 7, *distortion = x + 9, *point = x + 11;
  double const focal = x[6], weight = x[14];
  double p[3], axis[3];
  for (int i = 0; i < 3; i++) p[i] = point[i] - centre[i];
  double const angle = std::sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
  double const c = std::cos(angle), s = std::sin(angle);
  for (int i = 0; i < 3; i++) axis[i] = turn[i] / angle;
  double const along = (axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2]) * (1.0 - c);
  double turned[3];
  for (int i = 0; i < 3; i++) {
    int const j = (i + 1) % 3, k = (i + 2) % 3;
    turned[i] = p[i] * c + (axis[j] * p[k] - axis[k] * p[j]) * s + axis[i] * along;
  }
  double const u = turned[0] / turned[2], v = turned[1] / turned[2];
  double const square = u * u + v * v, radial = 1.0 + distortion[0] * square + distortion[1] * square * square;
  y[0] = weight * (u * radial * focal + principal[0] - z[0]);
  y[1] = weight * (v * radial * focal + principal[1] - z[1]);
  y[2] = 1.0 - weight * weight;
}
