#include "engine/analysis/figures/growth.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace symreal {

namespace {

constexpr std::size_t highest_exact = 6, highest_fitted = 3;
constexpr double close = 0.03;

// Solves a small linear system by Gaussian elimination with pivoting; the last column is the right-hand side.
std::vector<double> solved(std::vector<std::vector<long double>> rows) {
  std::size_t const n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    auto const pivot = std::max_element(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                                        [&](auto const &a, auto const &b) { return std::abs(a[k]) < std::abs(b[k]); });
    std::swap(rows[k], *pivot);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      long double const factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<double> result;
  for (std::size_t k = 0; k < n; ++k) result.push_back(static_cast<double>(rows[k][n] / rows[k][k]));
  return result;
}

// Coefficients by least squares, which weights large sizes most.
std::vector<double> coefficients(std::vector<Point> const &points, std::size_t degree) {
  std::vector<std::vector<long double>> rows(degree + 1, std::vector<long double>(degree + 2));
  for (Point const &point : points) {
    std::vector<long double> power(degree + 1, 1);
    for (std::size_t k = 1; k <= degree; ++k) power[k] = power[k - 1] * point.size;
    for (std::size_t i = 0; i <= degree; ++i) {
      for (std::size_t j = 0; j <= degree; ++j) rows[i][j] += power[i] * power[j];
      rows[i][degree + 1] += power[i] * point.figure;
    }
  }
  return solved(std::move(rows));
}

// Coefficients of the interpolating polynomial, by Newton's form.
std::vector<double> through(std::vector<Point> const &points) {
  std::vector<long double> difference;
  for (Point const &point : points) difference.push_back(point.figure);
  for (std::size_t order = 1; order < points.size(); ++order)
    for (std::size_t k = points.size(); k-- > order;)
      difference[k] =
          (difference[k] - difference[k - 1]) / (static_cast<long double>(points[k].size) - points[k - order].size);
  std::vector<long double> sum(points.size());
  for (std::size_t k = points.size(); k-- > 0;) {
    for (std::size_t power = points.size(); power-- > 0;)
      sum[power] = (power > 0 ? sum[power - 1] : 0) - sum[power] * points[k].size;
    sum[0] += difference[k];
  }
  return {sum.begin(), sum.end()};
}

// Root mean square of the deviation, relative to that of the figures.
double residual(Polynomial const &polynomial, std::vector<Point> const &points) {
  double off = 0, all = 0;
  for (Point const &point : points) {
    off += std::pow(polynomial.at(point.size) - point.figure, 2);
    all += point.figure * point.figure;
  }
  return off == 0 ? 0 : std::sqrt(off / all);
}

bool goes_through(Polynomial const &polynomial, Point const &point) {
  return std::abs(polynomial.at(point.size) - point.figure) <= 1e-6 * std::max(1.0, 1e-3 * std::abs(point.figure));
}

std::optional<Polynomial> exact(std::vector<Point> const &points) {
  for (std::size_t degree = 0; degree <= highest_exact && degree + 3 <= points.size(); ++degree) {
    Polynomial result{through({points.end() - static_cast<std::ptrdiff_t>(degree) - 1, points.end()})};
    std::size_t reached = 0;
    while (reached < points.size() && goes_through(result, points[points.size() - 1 - reached])) ++reached;
    if (reached < degree + 3 || 2 * reached <= points.size()) continue;
    result.from = points[points.size() - reached].size;
    result.is_exact = true;
    for (double &coefficient : result.coefficient)
      if (std::abs(coefficient) < 1e-9) coefficient = 0;
    return result;
  }
  return {};
}

} // namespace

std::optional<Power> fit_power(std::vector<Point> const &points) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (Point const &point : points) {
    if (!(point.size > 0 && point.figure > 0)) return {};
    double const a = std::log(point.size), b = std::log(point.figure);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  double const spread = n * xx - x * x;
  if (!(spread > 1e-12)) return {};
  double const exponent = (n * xy - x * y) / spread;
  Power result{std::exp((y - exponent * x) / n), exponent, 0};
  for (Point const &point : points) {
    double const off = result.factor * std::pow(point.size, exponent) / point.figure - 1;
    result.residual += off * off / n;
  }
  result.residual = std::sqrt(result.residual);
  return result;
}

std::optional<Polynomial> fit_polynomial(std::vector<Point> const &points) {
  if (auto found = exact(points)) return found;
  std::optional<Polynomial> best;
  for (std::size_t degree = 0; degree <= highest_fitted && degree + 2 <= points.size(); ++degree) {
    Polynomial candidate{coefficients(points, degree)};
    candidate.from = points.front().size;
    candidate.residual = residual(candidate, points);
    if (!best || candidate.residual < best->residual) best = candidate;
    if (best->residual < close) break;
  }
  return best;
}

double Polynomial::at(double size) const {
  long double value = 0;
  for (std::size_t k = coefficient.size(); k-- > 0;) value = value * size + coefficient[k];
  return static_cast<double>(value);
}

std::string to_string(Polynomial const &polynomial, std::string const &name) {
  std::string text;
  for (std::size_t k = polynomial.coefficient.size(); k-- > 0;) {
    double const value = polynomial.coefficient[k];
    if (value == 0) continue;
    std::string const power = k == 0 ? "" : k == 1 ? name : fmt::format("{}^{}", name, k);
    bool const is_one = k != 0 && std::abs(value) == 1;
    text += text.empty() ? (value < 0 ? "-" : "") : (value < 0 ? " - " : " + ");
    if (!is_one) text += fmt::format("{:.6g}", std::abs(value));
    text += (is_one || k == 0 ? "" : " ") + power;
  }
  return text.empty() ? "0" : text;
}

std::string to_string(Power const &power, std::string const &name) {
  return fmt::format("{:.3g} {}^{:.2f}", power.factor, name, power.exponent);
}

} // namespace symreal
