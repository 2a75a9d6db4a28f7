#include "tree.h"

namespace tree {

namespace {

struct Motion {
  Vec3 angular, linear; // of the frame's origin
};
struct Force {
  Vec3 moment, force; // about the frame's origin
};

Motion operator+(Motion const &a, Motion const &b) { return {a.angular + b.angular, a.linear + b.linear}; }
Force operator+(Force const &a, Force const &b) { return {a.moment + b.moment, a.force + b.force}; }

// R: from the body's frame to the parent's.
Motion to_body(Mat3 const &R, Vec3 offset, Motion const &m) {
  Mat3 const back = transpose(R);
  return {back * m.angular, back * (m.linear + cross(m.angular, offset))};
}
Force to_parent(Mat3 const &R, Vec3 offset, Force const &f) {
  Vec3 const force = R * f.force;
  return {R * f.moment + cross(offset, force), force};
}

Force momentum(Body const &body, Motion const &v) {
  return {body.inertia * v.angular + cross(body.moment, v.linear),
          body.mass * v.linear - cross(body.moment, v.angular)};
}
Force rate_of_turning(Motion const &v, Force const &h) {
  return {cross(v.angular, h.moment) + cross(v.linear, h.force), cross(v.angular, h.force)};
}
Motion turning(Motion const &v, Vec3 joint_velocity) {
  return {cross(v.angular, joint_velocity), cross(v.linear, joint_velocity)};
}

Mat3 crossing(Vec3 a) { return {{{0, -a.z, a.y}, {a.z, 0, -a.x}, {-a.y, a.x, 0}}}; }
Mat3 turned(Mat3 const &R, Mat3 const &m) { return R * m * transpose(R); }

Motion const at_rest = {{0, 0, 0}, {0, 0, 0}};
// The base accelerates upwards in place of the bodies being pulled down.
Motion lifted(Tree const &tree) { return {{0, 0, 0}, -tree.gravity}; }

} // namespace

void inverse_dynamics(Tree const &tree, double const *q, double const *qd, double const *qdd, double *tau) {
  Mat3 R[max_bodies];
  Motion v[max_bodies], a[max_bodies];
  Force f[max_bodies];
  for (int i = 0; i < tree.n; i++) {
    Body const &body = tree.body[i];
    bool const root = body.parent < 0;
    R[i] = joint_rotation(body, q[i]);
    v[i] = to_body(R[i], body.offset, root ? at_rest : v[body.parent]);
    v[i].angular = v[i].angular + qd[i] * body.axis;
    a[i] = to_body(R[i], body.offset, root ? lifted(tree) : a[body.parent]) + turning(v[i], qd[i] * body.axis);
    a[i].angular = a[i].angular + qdd[i] * body.axis;
    f[i] = momentum(body, a[i]) + rate_of_turning(v[i], momentum(body, v[i]));
  }
  for (int i = tree.n - 1; i >= 0; i--) {
    Body const &body = tree.body[i];
    tau[i] = dot(body.axis, f[i].moment);
    if (body.parent >= 0) f[body.parent] = f[body.parent] + to_parent(R[i], body.offset, f[i]);
  }
}

void mass_matrix(Tree const &tree, double const *q, double *H) {
  int const n = tree.n;
  Mat3 R[max_bodies], inertia[max_bodies];
  Vec3 moment[max_bodies];
  double mass[max_bodies];
  for (int i = 0; i < n; i++) {
    R[i] = joint_rotation(tree.body[i], q[i]);
    inertia[i] = tree.body[i].inertia;
    moment[i] = tree.body[i].moment;
    mass[i] = tree.body[i].mass;
    for (int j = 0; j < n; j++) H[i * n + j] = 0;
  }
  for (int i = n - 1; i >= 0; i--) {
    Body const &body = tree.body[i];
    Force f = {inertia[i] * body.axis, cross(body.axis, moment[i])};
    H[i * n + i] = dot(body.axis, f.moment);
    for (int j = i, k = body.parent; k >= 0; j = k, k = tree.body[k].parent) {
      f = to_parent(R[j], tree.body[j].offset, f);
      H[i * n + k] = H[k * n + i] = dot(tree.body[k].axis, f.moment);
    }
    if (body.parent < 0) continue;
    Vec3 const h = R[i] * moment[i];
    Mat3 const r = crossing(body.offset), mixed = r * crossing(h);
    inertia[body.parent] = inertia[body.parent] + turned(R[i], inertia[i]) - mixed - transpose(mixed) -
                           r * crossing(mass[i] * body.offset);
    moment[body.parent] = moment[body.parent] + h + mass[i] * body.offset;
    mass[body.parent] += mass[i];
  }
}

void forward_dynamics(Tree const &tree, double const *q, double const *qd, double const *tau, double *qdd) {
  Mat3 R[max_bodies];
  Motion v[max_bodies], c[max_bodies], a[max_bodies];
  // The articulated inertia: moment = A angular + B linear, force = B^T angular + C linear.
  Mat3 A[max_bodies], B[max_bodies], C[max_bodies];
  Force bias[max_bodies], U[max_bodies];
  double d[max_bodies], u[max_bodies];
  for (int i = 0; i < tree.n; i++) {
    Body const &body = tree.body[i];
    R[i] = joint_rotation(body, q[i]);
    v[i] = to_body(R[i], body.offset, body.parent < 0 ? at_rest : v[body.parent]);
    v[i].angular = v[i].angular + qd[i] * body.axis;
    c[i] = turning(v[i], qd[i] * body.axis);
    A[i] = body.inertia;
    B[i] = crossing(body.moment);
    C[i] = dh::diagonal(body.mass);
    bias[i] = rate_of_turning(v[i], momentum(body, v[i]));
  }
  for (int i = tree.n - 1; i >= 0; i--) {
    Body const &body = tree.body[i];
    int const p = body.parent;
    U[i] = {A[i] * body.axis, transpose(B[i]) * body.axis};
    d[i] = dot(body.axis, U[i].moment);
    u[i] = tau[i] - dot(body.axis, bias[i].moment);
    if (p < 0) continue;
    double const inverse = 1 / d[i];
    Mat3 const Aa = A[i] - outer(inverse * U[i].moment, U[i].moment);
    Mat3 const Ba = B[i] - outer(inverse * U[i].moment, U[i].force);
    Mat3 const Ca = C[i] - outer(inverse * U[i].force, U[i].force);
    double const share = u[i] * inverse;
    Force const moved = {Aa * c[i].angular + Ba * c[i].linear, transpose(Ba) * c[i].angular + Ca * c[i].linear};
    Force const pull = bias[i] + moved + Force{share * U[i].moment, share * U[i].force};
    bias[p] = bias[p] + to_parent(R[i], body.offset, pull);
    // Turned into the parent's axes, then about its origin.
    Mat3 const r = crossing(body.offset), At = turned(R[i], Aa), Bt = turned(R[i], Ba), Ct = turned(R[i], Ca);
    Mat3 const Bs = Bt + r * Ct;
    A[p] = A[p] + At - Bt * r + r * transpose(Bs);
    B[p] = B[p] + Bs;
    C[p] = C[p] + Ct;
  }
  for (int i = 0; i < tree.n; i++) {
    Body const &body = tree.body[i];
    a[i] = to_body(R[i], body.offset, body.parent < 0 ? lifted(tree) : a[body.parent]) + c[i];
    qdd[i] = (u[i] - dot(U[i].moment, a[i].angular) - dot(U[i].force, a[i].linear)) / d[i];
    a[i].angular = a[i].angular + qdd[i] * body.axis;
  }
}

} // namespace tree
