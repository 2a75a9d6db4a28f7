// The same link on a law that remembers: each call counts, and their order.
#include "link.h"

#include <cstdio>

#pragma symreal external(sticking_force)

#pragma symreal function input(q[0:3], v[0:3]) range(-1, 1) \
    parameter(link.mass, link.length, link.stiffness) constant(h) output(q[0:3], v[0:3], slip[0:2])
void step(Link link, double h, double *q, double *v, double *slip) {
  double a[3] = {0, -9.81, 0};
  for (int point = 0; point < 2; ++point) {
    End const end = end_of(link, q, v, 2 * point - 1);
    double force[2];
    anchor const held = sticking_force(point, link.stiffness, end.position, end.velocity, force);
    slip[point] = held.holds * (end.position[0] - held.x);
    accelerate(link, end, force, a);
  }
  for (int i = 0; i < 3; ++i) {
    v[i] += h * a[i];
    q[i] += h * v[i];
  }
}

int main() {
  Link const link = {1.5, 0.8, 2e4};
  double q[3] = {0, 0.3, 0.2}, v[3] = {0.5, 0, 0}, slip[2];
  for (int k = 0; k < 3000; ++k) {
    step(link, 1e-3, q, v, slip);
    if (k % 500 == 499) std::printf("%.10f %.10f %.10f %.3e %.3e\n", q[0], q[1], q[2], slip[0], slip[1]);
  }
}
