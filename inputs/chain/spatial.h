// Six-dimensional vectors and matrices of rigid-body dynamics, stored and multiplied in full: angular part first, then
// linear, as in Featherstone's "Rigid Body Dynamics Algorithms".
#ifndef CHAIN_SPATIAL_H
#define CHAIN_SPATIAL_H

namespace chain {

class SpatialVector {
public:
  SpatialVector() : elements_{} {}
  double &operator[](int i) { return elements_[i]; }
  double const &operator[](int i) const { return elements_[i]; }
  SpatialVector &operator+=(SpatialVector const &other);

private:
  double elements_[6];
};

class SpatialMatrix {
public:
  SpatialMatrix() : elements_{} {}
  static SpatialMatrix identity();
  double &operator()(int row, int column) { return elements_[row][column]; }
  double const &operator()(int row, int column) const { return elements_[row][column]; }
  SpatialMatrix &operator+=(SpatialMatrix const &other);
  SpatialMatrix transpose() const;

private:
  double elements_[6][6];
};

SpatialVector operator+(SpatialVector const &a, SpatialVector const &b);
SpatialVector operator*(SpatialVector const &a, double scale);
SpatialVector operator*(SpatialMatrix const &A, SpatialVector const &x);
SpatialMatrix operator*(SpatialMatrix const &A, SpatialMatrix const &B);
SpatialMatrix operator-(SpatialMatrix const &A, SpatialMatrix const &B);
double dot(SpatialVector const &a, SpatialVector const &b);
SpatialMatrix outer_product(SpatialVector const &a, SpatialVector const &b);

// Coordinate transforms of motion vectors: from a frame to the one that is turned by `angle` about axis 0, 1 or 2, or
// shifted by r.
SpatialMatrix rotation(int axis, double angle);
SpatialMatrix translation(double const r[3]);

// Cross products with a motion vector, as matrices: on motions and on forces.
SpatialMatrix cross_motion(SpatialVector const &v);
SpatialMatrix cross_force(SpatialVector const &v);

// Inertia about the frame's origin of a body whose inertia about its centre of mass c is given.
SpatialMatrix rigid_body_inertia(double mass, double const c[3], double const inertia[3][3]);

} // namespace chain

#endif
