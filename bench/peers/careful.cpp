// What inputs/chain/algorithms.cpp computes, as an expert writes it by hand: vectors of three components, symmetric
// matrices of six, turns about one axis, shifts apart from turns. Nothing that is zero or known twice is computed.
#include "algorithms.h"

#include <cmath>

namespace chain {

namespace {

struct Vector {
  double x = 0.0, y = 0.0, z = 0.0;
};

struct Symmetric {
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
};

struct Matrix {
  Vector x, y, z; // rows
};

inline Vector operator+(Vector const &a, Vector const &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(Vector const &a, Vector const &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator*(double scale, Vector const &a) { return {scale * a.x, scale * a.y, scale * a.z}; }
inline double dot(Vector const &a, Vector const &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(Vector const &a, Vector const &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector operator*(Symmetric const &A, Vector const &v) {
  return {A.xx * v.x + A.xy * v.y + A.xz * v.z, A.xy * v.x + A.yy * v.y + A.yz * v.z,
          A.xz * v.x + A.yz * v.y + A.zz * v.z};
}

// The coordinates of an axis, and of the two that follow it.
template <int Axis> double &along(Vector &v) { return Axis == 0 ? v.x : Axis == 1 ? v.y : v.z; }
template <int Axis> double along(Vector const &v) { return Axis == 0 ? v.x : Axis == 1 ? v.y : v.z; }
constexpr int next(int axis) { return (axis + 1) % 3; }
constexpr int last(int axis) { return (axis + 2) % 3; }
template <int I, int J> double &element(Symmetric &A) {
  return I == J ? (I == 0 ? A.xx : I == 1 ? A.yy : A.zz) : I + J == 1 ? A.xy : I + J == 2 ? A.xz : A.yz;
}
template <int I, int J> double element(Symmetric const &A) { return element<I, J>(const_cast<Symmetric &>(A)); }
template <int I> Vector &row(Matrix &A) { return I == 0 ? A.x : I == 1 ? A.y : A.z; }
template <int I> Vector const &row(Matrix const &A) { return I == 0 ? A.x : I == 1 ? A.y : A.z; }

struct Turn {
  double c, s;
};

// From the parent's frame to the one that is turned about the axis, and back.
template <int Axis> Vector inward(Turn const &turn, Vector const &v) {
  Vector result = v;
  double const y = along<next(Axis)>(v), z = along<last(Axis)>(v);
  along<next(Axis)>(result) = turn.c * y + turn.s * z;
  along<last(Axis)>(result) = turn.c * z - turn.s * y;
  return result;
}
template <int Axis> Vector outward(Turn const &turn, Vector const &v) {
  Vector result = v;
  double const y = along<next(Axis)>(v), z = along<last(Axis)>(v);
  along<next(Axis)>(result) = turn.c * y - turn.s * z;
  along<last(Axis)>(result) = turn.s * y + turn.c * z;
  return result;
}
template <int Axis> Symmetric outward(Turn const &turn, Symmetric const &A) {
  constexpr int Y = next(Axis), Z = last(Axis);
  double const yy = element<Y, Y>(A), yz = element<Y, Z>(A), zz = element<Z, Z>(A);
  double const cs = turn.c * turn.s, ss = turn.s * turn.s, difference = yy - zz;
  double const moved = ss * difference + 2.0 * cs * yz;
  double const xy = element<Axis, Y>(A), xz = element<Axis, Z>(A);
  Symmetric result = A;
  element<Y, Y>(result) = yy - moved;
  element<Z, Z>(result) = zz + moved;
  element<Y, Z>(result) = cs * difference + (1.0 - 2.0 * ss) * yz;
  element<Axis, Y>(result) = turn.c * xy - turn.s * xz;
  element<Axis, Z>(result) = turn.s * xy + turn.c * xz;
  return result;
}
template <int Axis> Matrix outward(Turn const &turn, Matrix const &A) {
  Vector const x = outward<Axis>(turn, row<Axis>(A));
  Vector const y = outward<Axis>(turn, row<next(Axis)>(A)), z = outward<Axis>(turn, row<last(Axis)>(A));
  Matrix result;
  row<Axis>(result) = x;
  row<next(Axis)>(result) = turn.c * y - turn.s * z;
  row<last(Axis)>(result) = turn.s * y + turn.c * z;
  return result;
}

template <int I> struct Axis {
  static constexpr int value = I;
};

// Calls step with the axis as a constant.
template <class Step> void about(int axis, Step const &step) {
  if (axis == 0) step(Axis<0>());
  if (axis == 1) step(Axis<1>());
  if (axis == 2) step(Axis<2>());
}

struct Body {
  int axis;
  Vector offset;
  double mass;
  Vector moment;     // mass times centre
  Symmetric inertia; // about the frame's origin
};

Body body(Model const &model, int i) {
  Link const &link = model.link(i);
  SpatialMatrix const &I = model.inertia(i);
  return {link.axis,
          {link.offset[0], link.offset[1], link.offset[2]},
          link.mass,
          {I(2, 4), I(0, 5), I(1, 3)},
          {I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2)}};
}

Turn turn(double angle) { return {std::cos(angle), std::sin(angle)}; }

// The base accelerates upwards instead of the links being pulled down.
constexpr Vector base_acceleration{0.0, 0.0, 9.80665};

} // namespace

void forward_kinematics(Model const &model, double const *q, double *pose) {
  Matrix R{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  Vector p;
  for (int i = 0; i < model.size(); i++) {
    Link const &link = model.link(i);
    Turn const joint = turn(q[i]);
    Vector const offset{link.offset[0], link.offset[1], link.offset[2]};
    p = p + Vector{dot(R.x, offset), dot(R.y, offset), dot(R.z, offset)};
    about(link.axis, [&](auto axis) {
      R.x = inward<axis.value>(joint, R.x);
      R.y = inward<axis.value>(joint, R.y);
      R.z = inward<axis.value>(joint, R.z);
    });
  }
  double const result[12] = {R.x.x, R.x.y, R.x.z, R.y.x, R.y.y, R.y.z, R.z.x, R.z.y, R.z.z, p.x, p.y, p.z};
  for (int i = 0; i < 12; i++) pose[i] = result[i];
}

void inverse_dynamics(Model const &model, double const *q, double const *qd, double const *qdd, double *tau) {
  int const n = model.size();
  std::vector<Turn> joint(n);
  std::vector<Vector> force(n), couple(n);
  Vector w, dw, a = base_acceleration;
  for (int i = 0; i < n; i++) {
    Body const link = body(model, i);
    joint[i] = turn(q[i]);
    about(link.axis, [&](auto axis) {
      constexpr int X = axis.value;
      if (i > 0) a = a + cross(dw, link.offset) + cross(w, cross(w, link.offset));
      a = inward<X>(joint[i], a);
      w = inward<X>(joint[i], w);
      dw = inward<X>(joint[i], dw);
      along<next(X)>(dw) += along<last(X)>(w) * qd[i];
      along<last(X)>(dw) -= along<next(X)>(w) * qd[i];
      along<X>(dw) += qdd[i];
      along<X>(w) += qd[i];
    });
    force[i] = link.mass * a + cross(dw, link.moment) + cross(w, cross(w, link.moment));
    couple[i] = link.inertia * dw + cross(w, link.inertia * w) + cross(link.moment, a);
  }
  for (int i = n - 1; i >= 0; i--) {
    Body const link = body(model, i);
    about(link.axis, [&](auto axis) {
      constexpr int X = axis.value;
      tau[i] = along<X>(couple[i]);
      if (i == 0) return;
      Vector const f = outward<X>(joint[i], force[i]);
      force[i - 1] = force[i - 1] + f;
      couple[i - 1] = couple[i - 1] + outward<X>(joint[i], couple[i]) + cross(link.offset, f);
    });
  }
}

void mass_matrix(Model const &model, double const *q, double *H) {
  int const n = model.size();
  std::vector<Turn> joint(n);
  std::vector<Body> composite(n);
  for (int i = 0; i < n; i++) {
    joint[i] = turn(q[i]);
    composite[i] = body(model, i);
  }
  for (int i = n - 1; i > 0; i--) {
    Body const &link = composite[i];
    Body &parent = composite[i - 1];
    about(link.axis, [&](auto axis) {
      constexpr int X = axis.value;
      Vector const &r = link.offset;
      Vector const moment = outward<X>(joint[i], link.moment), shift = link.mass * r;
      Symmetric const turned = outward<X>(joint[i], link.inertia);
      Vector const s = moment + 0.5 * shift;
      double const xx = 2.0 * s.x * r.x, yy = 2.0 * s.y * r.y, zz = 2.0 * s.z * r.z;
      parent.mass += link.mass;
      parent.moment = parent.moment + moment + shift;
      parent.inertia.xx += turned.xx + yy + zz;
      parent.inertia.yy += turned.yy + xx + zz;
      parent.inertia.zz += turned.zz + xx + yy;
      parent.inertia.xy += turned.xy - s.x * r.y - s.y * r.x;
      parent.inertia.xz += turned.xz - s.x * r.z - s.z * r.x;
      parent.inertia.yz += turned.yz - s.y * r.z - s.z * r.y;
    });
  }
  for (int i = 0; i < n; i++) {
    Vector f, c;
    about(composite[i].axis, [&](auto axis) {
      constexpr int X = axis.value;
      along<next(X)>(f) = -along<last(X)>(composite[i].moment);
      along<last(X)>(f) = along<next(X)>(composite[i].moment);
      along<X>(c) = element<X, X>(composite[i].inertia);
      along<next(X)>(c) = element<X, next(X)>(composite[i].inertia);
      along<last(X)>(c) = element<X, last(X)>(composite[i].inertia);
      H[i * n + i] = along<X>(c);
    });
    for (int j = i; j > 0; j--) {
      about(composite[j].axis, [&](auto axis) {
        f = outward<axis.value>(joint[j], f);
        c = outward<axis.value>(joint[j], c) + cross(composite[j].offset, f);
      });
      about(composite[j - 1].axis, [&](auto axis) { H[i * n + j - 1] = H[(j - 1) * n + i] = along<axis.value>(c); });
    }
  }
}

namespace {

// couple = rotational dw + mixed a + bias_couple, force = mixed^T dw + linear a + bias_force.
struct Articulated {
  Symmetric rotational, linear;
  Matrix mixed;
  Vector couple, force;
};

Symmetric minus_product(Symmetric const &A, Vector const &k, Vector const &u) { // k u^T is symmetric
  return {A.xx - k.x * u.x, A.xy - k.x * u.y, A.xz - k.x * u.z, A.yy - k.y * u.y, A.yz - k.y * u.z, A.zz - k.z * u.z};
}

// The articulated inertia of a link as its parent sees it, added to the parent's.
template <int X> void pass_on(Articulated const &apparent, Turn const &joint, Vector const &r, Articulated &parent) {
  Symmetric const rotational = outward<X>(joint, apparent.rotational), linear = outward<X>(joint, apparent.linear);
  Matrix const mixed = outward<X>(joint, apparent.mixed);
  Vector const force = outward<X>(joint, apparent.force), couple = outward<X>(joint, apparent.couple);
  parent.force = parent.force + force;
  parent.couple = parent.couple + couple + cross(r, force);
  // The columns of r x linear, added to those of the mixed part.
  Vector const x = cross(r, {linear.xx, linear.xy, linear.xz}), y = cross(r, {linear.xy, linear.yy, linear.yz}),
               z = cross(r, {linear.xz, linear.yz, linear.zz});
  Matrix const moved{mixed.x + Vector{x.x, y.x, z.x}, mixed.y + Vector{x.y, y.y, z.y}, mixed.z + Vector{x.z, y.z, z.z}};
  parent.mixed = {parent.mixed.x + moved.x, parent.mixed.y + moved.y, parent.mixed.z + moved.z};
  parent.linear = {parent.linear.xx + linear.xx, parent.linear.xy + linear.xy, parent.linear.xz + linear.xz,
                   parent.linear.yy + linear.yy, parent.linear.yz + linear.yz, parent.linear.zz + linear.zz};
  // rotational + r x mixed^T + (r x moved^T)^T, of which each element is needed once.
  Vector const mx = cross(r, mixed.x), my = cross(r, mixed.y), mz = cross(r, mixed.z);
  Symmetric &sum = parent.rotational;
  sum.xx += rotational.xx + mx.x + (r.y * moved.x.z - r.z * moved.x.y);
  sum.xy += rotational.xy + my.x + (r.z * moved.x.x - r.x * moved.x.z);
  sum.xz += rotational.xz + mz.x + (r.x * moved.x.y - r.y * moved.x.x);
  sum.yy += rotational.yy + my.y + (r.z * moved.y.x - r.x * moved.y.z);
  sum.yz += rotational.yz + mz.y + (r.x * moved.y.y - r.y * moved.y.x);
  sum.zz += rotational.zz + mz.z + (r.x * moved.z.y - r.y * moved.z.x);
}

} // namespace

void forward_dynamics(Model const &model, double const *q, double const *qd, double const *tau, double *qdd) {
  int const n = model.size();
  std::vector<Turn> joint(n);
  std::vector<Articulated> bodies(n);
  std::vector<Vector> dw_of_rate(n), a_of_rate(n), column(n), force_column(n);
  std::vector<double> inverse(n), rest(n);
  Vector w, v;
  for (int i = 0; i < n; i++) {
    Body const link = body(model, i);
    joint[i] = turn(q[i]);
    about(link.axis, [&](auto axis) {
      constexpr int X = axis.value;
      if (i > 0) v = inward<X>(joint[i], v + cross(w, link.offset));
      w = inward<X>(joint[i], w);
      along<next(X)>(dw_of_rate[i]) = along<last(X)>(w) * qd[i];
      along<last(X)>(dw_of_rate[i]) = -(along<next(X)>(w) * qd[i]);
      along<next(X)>(a_of_rate[i]) = along<last(X)>(v) * qd[i];
      along<last(X)>(a_of_rate[i]) = -(along<next(X)>(v) * qd[i]);
      along<X>(w) += qd[i];
    });
    Vector const &h = link.moment;
    Vector const momentum = link.mass * v + cross(w, h);
    bodies[i].rotational = link.inertia;
    bodies[i].linear = {link.mass, 0.0, 0.0, link.mass, 0.0, link.mass};
    bodies[i].mixed = {{0.0, -h.z, h.y}, {h.z, 0.0, -h.x}, {-h.y, h.x, 0.0}};
    bodies[i].force = cross(w, momentum);
    bodies[i].couple = cross(w, link.inertia * w + cross(h, v)) + cross(v, momentum);
  }
  for (int i = n - 1; i >= 0; i--) {
    Body const link = body(model, i);
    about(link.axis, [&](auto axis) {
      constexpr int X = axis.value, Y = next(X), Z = last(X);
      Articulated const &own = bodies[i];
      Vector &u = column[i], &uf = force_column[i];
      along<X>(u) = element<X, X>(own.rotational);
      along<Y>(u) = element<X, Y>(own.rotational);
      along<Z>(u) = element<X, Z>(own.rotational);
      uf = row<X>(own.mixed);
      inverse[i] = 1.0 / along<X>(u);
      rest[i] = tau[i] - along<X>(own.couple);
      if (i == 0) return;
      // What is left of the inertia when the joint gives way: nothing about the joint's axis.
      double const ky = along<Y>(u) * inverse[i], kz = along<Z>(u) * inverse[i], share = rest[i] * inverse[i];
      Articulated apparent;
      element<Y, Y>(apparent.rotational) = element<Y, Y>(own.rotational) - ky * along<Y>(u);
      element<Y, Z>(apparent.rotational) = element<Y, Z>(own.rotational) - ky * along<Z>(u);
      element<Z, Z>(apparent.rotational) = element<Z, Z>(own.rotational) - kz * along<Z>(u);
      row<Y>(apparent.mixed) = row<Y>(own.mixed) - ky * uf;
      row<Z>(apparent.mixed) = row<Z>(own.mixed) - kz * uf;
      apparent.linear = minus_product(own.linear, inverse[i] * uf, uf);
      double const wy = along<Y>(dw_of_rate[i]), wz = along<Z>(dw_of_rate[i]);
      double const vy = along<Y>(a_of_rate[i]), vz = along<Z>(a_of_rate[i]);
      Vector const &my = row<Y>(apparent.mixed), &mz = row<Z>(apparent.mixed);
      Symmetric const &rotational = apparent.rotational, &linear = apparent.linear;
      along<X>(apparent.couple) = tau[i];
      along<Y>(apparent.couple) = along<Y>(own.couple) + share * along<Y>(u) + element<Y, Y>(rotational) * wy +
                                  element<Y, Z>(rotational) * wz + along<Y>(my) * vy + along<Z>(my) * vz;
      along<Z>(apparent.couple) = along<Z>(own.couple) + share * along<Z>(u) + element<Y, Z>(rotational) * wy +
                                  element<Z, Z>(rotational) * wz + along<Y>(mz) * vy + along<Z>(mz) * vz;
      Vector linear_y, linear_z;
      along<X>(linear_y) = element<X, Y>(linear), along<Y>(linear_y) = element<Y, Y>(linear);
      along<Z>(linear_y) = along<Y>(linear_z) = element<Y, Z>(linear);
      along<X>(linear_z) = element<X, Z>(linear), along<Z>(linear_z) = element<Z, Z>(linear);
      apparent.force = own.force + share * uf + wy * my + wz * mz + vy * linear_y + vz * linear_z;
      pass_on<X>(apparent, joint[i], link.offset, bodies[i - 1]);
    });
  }
  Vector dw, a = base_acceleration;
  for (int i = 0; i < n; i++) {
    Body const link = body(model, i);
    about(link.axis, [&](auto axis) {
      constexpr int X = axis.value, Y = next(X), Z = last(X);
      if (i > 0) a = a + cross(dw, link.offset);
      a = inward<X>(joint[i], a);
      dw = inward<X>(joint[i], dw);
      if (i > 0) {
        along<Y>(dw) += along<Y>(dw_of_rate[i]), along<Z>(dw) += along<Z>(dw_of_rate[i]);
        along<Y>(a) += along<Y>(a_of_rate[i]), along<Z>(a) += along<Z>(a_of_rate[i]);
      }
      qdd[i] = (rest[i] - dot(column[i], dw) - dot(force_column[i], a)) * inverse[i];
      along<X>(dw) += qdd[i];
    });
  }
}

} // namespace chain
