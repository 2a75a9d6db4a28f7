// Vectors and matrices of three-dimensional space.
#pragma once

namespace dh {

struct Vec3 {
  double x, y, z;
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

struct Mat3 {
  Vec3 row[3];
};

inline Mat3 transpose(Mat3 const &m) {
  return {{{m.row[0].x, m.row[1].x, m.row[2].x},
           {m.row[0].y, m.row[1].y, m.row[2].y},
           {m.row[0].z, m.row[1].z, m.row[2].z}}};
}
inline Mat3 operator+(Mat3 const &a, Mat3 const &b) {
  return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}};
}
inline Mat3 operator-(Mat3 const &a, Mat3 const &b) {
  return {{a.row[0] - b.row[0], a.row[1] - b.row[1], a.row[2] - b.row[2]}};
}
inline Vec3 operator*(Mat3 const &m, Vec3 v) { return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)}; }
inline Mat3 operator*(Mat3 const &a, Mat3 const &b) {
  Mat3 const t = transpose(b);
  return {{t * a.row[0], t * a.row[1], t * a.row[2]}};
}

// a b^T, and the identity scaled
inline Mat3 outer(Vec3 a, Vec3 b) { return {{a.x * b, a.y * b, a.z * b}}; }
inline Mat3 diagonal(double s) { return {{{s, 0, 0}, {0, s, 0}, {0, 0, s}}}; }

} // namespace dh
