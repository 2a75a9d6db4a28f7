// N steps of the classical method of Runge and Kutta for a heavy top: a quaternion, its angular velocity, and a full
// inertia matrix, with small matrices as they stand in a textbook.
#include <array>
#include <cstdlib>

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;
using State = std::array<double, 7>; // the quaternion, the angular velocity in the frame of the body

static Vector cross(Vector const &a, Vector const &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

static Vector operator*(Matrix const &m, Vector const &v) {
  Vector result = {};
  for (int row = 0; row < 3; row++)
    for (int column = 0; column < 3; column++) result[row] += m[row][column] * v[column];
  return result;
}

static Matrix transposed(Matrix const &m) {
  Matrix result;
  for (int row = 0; row < 3; row++)
    for (int column = 0; column < 3; column++) result[row][column] = m[column][row];
  return result;
}

static Matrix inverse(Matrix const &m) {
  Vector const a = cross(m[1], m[2]), b = cross(m[2], m[0]), c = cross(m[0], m[1]);
  double const determinant = m[0][0] * a[0] + m[0][1] * a[1] + m[0][2] * a[2];
  Matrix adjugate = transposed({a, b, c});
  for (Vector &row : adjugate)
    for (double &element : row) element /= determinant;
  return adjugate;
}

// From the frame of the body to that of the ground.
static Matrix rotation(State const &s) {
  double const w = s[0], x = s[1], y = s[2], z = s[3];
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

struct Top {
  Matrix inertia;
  Vector centre;
  double weight;
};

static State slope(State const &s, Top const &top) {
  Vector const spin = {s[4], s[5], s[6]};
  Vector const weight = transposed(rotation(s)) * Vector{0, 0, -top.weight};
  Vector torque = cross(top.centre, weight);
  Vector const gyration = cross(spin, top.inertia * spin);
  for (int k = 0; k < 3; k++) torque[k] -= gyration[k];
  Vector const acceleration = inverse(top.inertia) * torque;
  double const turn[4][4] = {{0, -spin[0], -spin[1], -spin[2]},
                             {spin[0], 0, spin[2], -spin[1]},
                             {spin[1], -spin[2], 0, spin[0]},
                             {spin[2], spin[1], -spin[0], 0}};
  State result = {0, 0, 0, 0, acceleration[0], acceleration[1], acceleration[2]};
  for (int row = 0; row < 4; row++)
    for (int column = 0; column < 4; column++) result[row] += 0.5 * turn[row][column] * s[column];
  return result;
}

static State moved(State s, State const &by, double h) {
  for (int k = 0; k < 7; k++) s[k] += h * by[k];
  return s;
}

#pragma symreal function input(begin[0 : 7], inertia[0 : 9], centre[0 : 3], weight) constant(steps) output(end[0 : 7])
void top(double const *begin, double const *inertia, double const *centre, double weight, int steps, double *end) {
  Top model = {{}, {centre[0], centre[1], centre[2]}, weight};
  for (int k = 0; k < 9; k++) model.inertia[k / 3][k % 3] = inertia[k];
  State s;
  for (int k = 0; k < 7; k++) s[k] = begin[k];
  double const h = 1.0 / 1024;
  for (int step = 0; step < steps; step++) {
    State const k1 = slope(s, model), k2 = slope(moved(s, k1, h / 2), model), k3 = slope(moved(s, k2, h / 2), model),
                k4 = slope(moved(s, k3, h), model);
    for (int k = 0; k < 7; k++) s[k] += h / 6 * (k1[k] + 2 * k2[k] + 2 * k3[k] + k4[k]);
  }
  for (int k = 0; k < 7; k++) end[k] = s[k];
}

// The quaternion and its angular velocity, the inertia matrix, the centre, the weight.
static double const example[20] = {0.8,     0.6,   0,        0,      0.5,      0.25, 8,       0.5,      0.03125, 0.0625,
                                   0.03125, 0.625, 0.015625, 0.0625, 0.015625, 0.25, 0.03125, 0.015625, 0.5,     9.75};

#ifndef NO_MAIN
int main(int, char **argv) {
  double end[7];
  top(example, example + 7, example + 16, example[19], std::atoi(argv[1]), end);
}
#endif
