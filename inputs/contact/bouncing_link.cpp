// Symbolic dynamics around a numeric contact law: the law is a function of its arguments alone.
#include "link.h"

#include <cstdio>

#pragma symreal external(contact_force) pure

// One step of semi-implicit Euler.
#pragma symreal function input(q[0:3], v[0:3]) range(-1, 1) \
    parameter(link.mass, link.length, link.stiffness) constant(h) output(q[0:3], v[0:3])
void step(Link link, double h, double *q, double *v) {
  double a[3] = {0, -9.81, 0};
  for (int point = 0; point < 2; ++point) {
    End const end = end_of(link, q, v, 2 * point - 1);
    double force[2];
    contact_force(link.stiffness, end.position, end.velocity, force);
    accelerate(link, end, force, a);
  }
  for (int i = 0; i < 3; ++i) {
    v[i] += h * a[i];
    q[i] += h * v[i];
  }
}

int main() {
  Link const link = {1.5, 0.8, 2e4};
  double q[3] = {0, 0.3, 0.2}, v[3] = {0.5, 0, 0};
  for (int k = 0; k < 3000; ++k) {
    step(link, 1e-3, q, v);
    if (k % 500 == 499) std::printf("%.10f %.10f %.10f\n", q[0], q[1], q[2]);
  }
}
