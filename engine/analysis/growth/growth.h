// How a figure grows with the size of a problem: a power, and a polynomial, fitted to the figures of a family.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace symreal {

struct Point {
  double size, figure;
};

// figure = factor * size^exponent, by least squares of the logarithms. The residual is the root of the mean square of
// the relative deviation. Nothing of fewer than two sizes, or where a size or a figure is not positive.
struct Power {
  double factor, exponent, residual;
};
std::optional<Power> fit_power(std::vector<Point> const &points);

// The polynomial of the smallest degree that goes through the points, which ascend in size. Exactly through a figure
// that is an integer, from size `from` on, where it goes through at least two more points than make it and through more
// than half of all: the first members of a family often differ. Otherwise by least squares, of the smallest degree up
// to 3 whose residual is below a hundredth, or of that with the least. The residual is as above.
struct Polynomial {
  std::vector<double> coefficient; // of size^0, size^1, ...
  double residual = 0, from = 0;
  bool is_exact = false;

  double at(double size) const;
};
std::optional<Polynomial> fit_polynomial(std::vector<Point> const &points);

// "12.5 N^2 - 3 N + 1"
std::string to_string(Polynomial const &polynomial, std::string const &name);
std::string to_string(Power const &power, std::string const &name);

} // namespace symreal
