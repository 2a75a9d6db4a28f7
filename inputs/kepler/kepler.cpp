// Where a body is on its orbit: Kepler's equation by Newton's method, then position and velocity from the elements.
//
// The number of iterations depends on the values. As it stands, the path taken can be recorded with its conditions
// (--decisions=guard); with -DBOUNDED the loop is unrolled a bounded number of times and left early.
#include <cmath>
#include <cstdio>

struct Elements {
  double axis, eccentricity, inclination, node, periapsis, anomaly; // m, -, rad, rad, rad, mean anomaly in rad
};

static double eccentric_anomaly(double mean, double e) {
  double E = mean + e * std::sin(mean);
#ifdef BOUNDED
#pragma symreal loop(12)
#endif
  for (int i = 0; i < 50; ++i) {
    double const step = (E - e * std::sin(E) - mean) / (1.0 - e * std::cos(E));
    E -= step;
    if (std::fabs(step) < 1e-12) break;
  }
  return E;
}

#pragma symreal function input(orbit.axis, orbit.eccentricity, orbit.inclination, orbit.node, orbit.periapsis, orbit.anomaly) parameter(mu) output(r[0:3], v[0:3])
void propagate(Elements orbit, double mu, double *r, double *v) {
  double const e = orbit.eccentricity;
  double const E = eccentric_anomaly(orbit.anomaly, e);
  double const cosine = std::cos(E), sine = std::sin(E), root = std::sqrt(1.0 - e * e);
  double const motion = std::sqrt(mu / orbit.axis) / (1.0 - e * cosine);
  // In the plane of the orbit, periapsis along x.
  double const x = orbit.axis * (cosine - e), y = orbit.axis * root * sine;
  double const vx = -motion * sine, vy = motion * root * cosine;

  double const cw = std::cos(orbit.periapsis), sw = std::sin(orbit.periapsis);
  double const cn = std::cos(orbit.node), sn = std::sin(orbit.node);
  double const ci = std::cos(orbit.inclination), si = std::sin(orbit.inclination);
  double const p[3] = {cn * cw - sn * sw * ci, sn * cw + cn * sw * ci, sw * si};
  double const q[3] = {-cn * sw - sn * cw * ci, -sn * sw + cn * cw * ci, cw * si};
  for (int k = 0; k < 3; ++k) {
    r[k] = p[k] * x + q[k] * y;
    v[k] = p[k] * vx + q[k] * vy;
  }
}

int main() {
  Elements const orbit = {2.6561e7, 0.74, 1.107, 0.35, 4.712, 0.8}; // a Molniya orbit
  double r[3], v[3];
  propagate(orbit, 3.986004418e14, r, v);
  for (double component : r) std::printf("%.10g ", component);
  for (double component : v) std::printf("%.10g ", component);
  std::printf("\n");
}
