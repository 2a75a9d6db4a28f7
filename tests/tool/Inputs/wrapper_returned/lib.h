#pragma once
#include <array>
#include <complex>
#include <utility>
#include <vector>

struct Pose {
  double at[2];
  struct {
    double angle;
  } heading;
  std::vector<double> joints;
  std::complex<double> phase;
};
class Hidden {
public:
  Hidden(double a, double b) : a_(a), b_(b) {}
  double sum() const { return a_ + 2 * b_; }

private:
  double a_, b_;
};

std::complex<double> root(double x);
std::array<double, 3> powers(double x);
std::vector<double> series(double x);
Pose pose(double x);
Hidden hidden(double x);
std::pair<double, double> both(double x);
