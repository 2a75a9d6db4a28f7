// Growth of a figure with the problem size: a power law and a polynomial, fitted to a family's figures.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace symreal {

struct Point {
  double size, figure;
};

// figure = factor * size^exponent, by least squares of the logarithms. The residual is the root mean square of the
// relative deviation. Returns nullopt for fewer than two sizes, or if a size or figure is not positive.
struct Power {
  double factor, exponent, residual;
};
std::optional<Power> fit_power(std::vector<Point> const &points);

// Polynomial of the smallest degree through the points, which ascend in size. Exact for integer figures from size
// `from` on if it passes through at least two more points than determine it and through more than half of all, since
// the first members of a family often differ. Otherwise a least-squares fit of the smallest degree up to 3 whose
// residual is below 0.03, else of the degree with the least residual. The residual is as above.
struct Polynomial {
  std::vector<double> coefficient; // coefficients of size^0, size^1, ...
  double residual = 0, from = 0;
  bool is_exact = false;

  double at(double size) const;
};
std::optional<Polynomial> fit_polynomial(std::vector<Point> const &points);

// "12.5 N^2 - 3 N + 1"
std::string to_string(Polynomial const &polynomial, std::string const &name);
std::string to_string(Power const &power, std::string const &name);

} // namespace symreal
