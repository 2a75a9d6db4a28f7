// The extended Kalman filter of inputs/kalman with Jacobians that nobody has written: symreal generate tracker_model.cpp
// --lang=cpp has made both headers.
#include "measurement.hpp"
#include "motion.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace {

template <std::size_t rows, std::size_t columns> using Matrix = std::array<std::array<double, columns>, rows>;

template <std::size_t n, std::size_t m, std::size_t k>
Matrix<n, k> product(Matrix<n, m> const &a, Matrix<m, k> const &b) {
  Matrix<n, k> result{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < k; ++j)
      for (std::size_t l = 0; l < m; ++l) result[i][j] += a[i][l] * b[l][j];
  return result;
}

template <std::size_t n, std::size_t m> Matrix<m, n> transposed(Matrix<n, m> const &a) {
  Matrix<m, n> result;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) result[j][i] = a[i][j];
  return result;
}

template <std::size_t n, std::size_t m> Matrix<n, m> matrix(double const (&values)[n][m]) {
  Matrix<n, m> result;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) result[i][j] = values[i][j];
  return result;
}

constexpr double dt = 0.1, sigma_acceleration = 0.8, sigma_yaw_acceleration = 0.3, sigma_drift = 0.05,
                 sigma_range = 0.25, sigma_bearing = 0.02;

struct Filter {
  motion::Input x;
  Matrix<5, 5> P;

  void predict() {
    double constants[motion::constant_count + 1], output[motion::output_count];
    motion::preprocess(&dt, constants);
    motion::compute(x.x, constants, output);
    auto const &next = reinterpret_cast<motion::Output const &>(output);
    Matrix<5, 5> const F = matrix(next.jacobian_next_x);
    for (int i = 0; i < 5; ++i) x.x[i] = next.next[i];
    P = product(product(F, P), transposed(F));
    double const acceleration = sigma_acceleration * sigma_acceleration;
    double const yaw_acceleration = sigma_yaw_acceleration * sigma_yaw_acceleration;
    for (std::size_t i : {0, 1}) P[i][i] += sigma_drift * sigma_drift * dt + acceleration * std::pow(dt, 4) / 4.0;
    P[2][2] += yaw_acceleration * std::pow(dt, 4) / 4.0;
    P[2][4] += yaw_acceleration * std::pow(dt, 3) / 2.0;
    P[4][2] += yaw_acceleration * std::pow(dt, 3) / 2.0;
    P[3][3] += acceleration * dt * dt;
    P[4][4] += yaw_acceleration * dt * dt;
  }

  void update(double const (&z)[2]) {
    double const beacon[2] = {20.0, -5.0};
    double constants[measurement::constant_count + 1], output[measurement::output_count];
    measurement::preprocess(beacon, constants);
    measurement::compute(x.x, constants, output);
    auto const &expected = reinterpret_cast<measurement::Output const &>(output);
    Matrix<2, 5> const H = matrix(expected.jacobian_z_x);
    double const bearing = z[1] - expected.z[1];
    double const innovation[2] = {z[0] - expected.z[0], std::atan2(std::sin(bearing), std::cos(bearing))};
    Matrix<5, 2> const PHt = product(P, transposed(H));
    Matrix<2, 2> S = product(H, PHt);
    S[0][0] += sigma_range * sigma_range;
    S[1][1] += sigma_bearing * sigma_bearing;
    double const determinant = S[0][0] * S[1][1] - S[0][1] * S[1][0];
    Matrix<2, 2> const inverse = {{{S[1][1] / determinant, -S[0][1] / determinant},
                                   {-S[1][0] / determinant, S[0][0] / determinant}}};
    Matrix<5, 2> const K = product(PHt, inverse);
    for (int i = 0; i < 5; ++i) x.x[i] += K[i][0] * innovation[0] + K[i][1] * innovation[1];
    Matrix<5, 5> const KHP = product(product(K, H), P);
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) P[i][j] -= KHP[i][j];
  }
};

} // namespace

int main() {
  double const measurements[3][2] = {{20.3, -0.52}, {20.1, -0.57}, {19.6, -0.61}};
  double const deviations[5] = {0.5, 0.5, 0.1, 0.4, 0.05};
  Filter filter{{{0.2, 0.1, 0.3, 4.0, 0.2}}, {}};
  for (int i = 0; i < 5; ++i) filter.P[i][i] = deviations[i] * deviations[i];
  for (auto const &z : measurements) {
    filter.predict();
    filter.update(z);
    for (int i = 0; i < 5; ++i) std::printf("%.17g%c", filter.x.x[i], i < 4 ? ' ' : '\n');
  }
  for (auto const &row : filter.P)
    for (int j = 0; j < 5; ++j) std::printf("%.17g%c", row[j], j < 4 ? ' ' : '\n');
}
