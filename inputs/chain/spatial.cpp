#include "spatial.h"

#include <cmath>

namespace chain {

SpatialVector &SpatialVector::operator+=(SpatialVector const &other) {
  for (int i = 0; i < 6; i++) elements_[i] += other.elements_[i];
  return *this;
}

SpatialMatrix SpatialMatrix::identity() {
  SpatialMatrix result;
  for (int i = 0; i < 6; i++) result(i, i) = 1.0;
  return result;
}

SpatialMatrix &SpatialMatrix::operator+=(SpatialMatrix const &other) {
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) elements_[i][j] += other.elements_[i][j];
  return *this;
}

SpatialMatrix SpatialMatrix::transpose() const {
  SpatialMatrix result;
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) result(i, j) = elements_[j][i];
  return result;
}

SpatialVector operator+(SpatialVector const &a, SpatialVector const &b) {
  SpatialVector sum = a;
  return sum += b;
}

SpatialVector operator*(SpatialVector const &a, double scale) {
  SpatialVector result;
  for (int i = 0; i < 6; i++) result[i] = a[i] * scale;
  return result;
}

SpatialVector operator*(SpatialMatrix const &A, SpatialVector const &x) {
  SpatialVector result;
  for (int i = 0; i < 6; i++) {
    double sum = A(i, 0) * x[0];
    for (int k = 1; k < 6; k++) sum += A(i, k) * x[k];
    result[i] = sum;
  }
  return result;
}

SpatialMatrix operator*(SpatialMatrix const &A, SpatialMatrix const &B) {
  SpatialMatrix result;
  for (int i = 0; i < 6; i++) {
    for (int j = 0; j < 6; j++) {
      double sum = A(i, 0) * B(0, j);
      for (int k = 1; k < 6; k++) sum += A(i, k) * B(k, j);
      result(i, j) = sum;
    }
  }
  return result;
}

SpatialMatrix operator-(SpatialMatrix const &A, SpatialMatrix const &B) {
  SpatialMatrix result;
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) result(i, j) = A(i, j) - B(i, j);
  return result;
}

double dot(SpatialVector const &a, SpatialVector const &b) {
  double sum = a[0] * b[0];
  for (int i = 1; i < 6; i++) sum += a[i] * b[i];
  return sum;
}

SpatialMatrix outer_product(SpatialVector const &a, SpatialVector const &b) {
  SpatialMatrix result;
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) result(i, j) = a[i] * b[j];
  return result;
}

SpatialMatrix rotation(int axis, double angle) {
  double const c = std::cos(angle), s = std::sin(angle);
  int const y = (axis + 1) % 3, z = (axis + 2) % 3;
  SpatialMatrix X;
  for (int block = 0; block < 6; block += 3) {
    X(block + axis, block + axis) = 1.0;
    X(block + y, block + y) = c;
    X(block + y, block + z) = s;
    X(block + z, block + y) = -s;
    X(block + z, block + z) = c;
  }
  return X;
}

SpatialMatrix translation(double const r[3]) {
  SpatialMatrix X = SpatialMatrix::identity();
  X(3, 1) = r[2];
  X(3, 2) = -r[1];
  X(4, 0) = -r[2];
  X(4, 2) = r[0];
  X(5, 0) = r[1];
  X(5, 1) = -r[0];
  return X;
}

SpatialMatrix cross_motion(SpatialVector const &v) {
  SpatialMatrix result;
  for (int block = 0; block < 6; block += 3) {
    double const x = v[block], y = v[block + 1], z = v[block + 2];
    result(block, 1) = -z;
    result(block, 2) = y;
    result(block + 1, 0) = z;
    result(block + 1, 2) = -x;
    result(block + 2, 0) = -y;
    result(block + 2, 1) = x;
  }
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) result(3 + i, 3 + j) = result(i, j);
  return result;
}

SpatialMatrix cross_force(SpatialVector const &v) {
  SpatialMatrix const motion = cross_motion(v);
  SpatialMatrix result;
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < 6; j++) result(i, j) = -motion(j, i);
  return result;
}

SpatialMatrix rigid_body_inertia(double mass, double const c[3], double const inertia[3][3]) {
  double const cross[3][3] = {{0.0, -c[2], c[1]}, {c[2], 0.0, -c[0]}, {-c[1], c[0], 0.0}};
  SpatialMatrix result;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      double sum = 0.0;
      for (int k = 0; k < 3; k++) sum += cross[i][k] * cross[j][k];
      result(i, j) = inertia[i][j] + mass * sum;
      result(i, 3 + j) = mass * cross[i][j];
      result(3 + i, j) = mass * cross[j][i];
    }
    result(3 + i, 3 + i) = mass;
  }
  return result;
}

} // namespace chain
