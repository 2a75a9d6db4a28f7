#include "engine/analysis/figures/growth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace symreal {
namespace {

template <class Figure> std::vector<Point> family(int first, int last, Figure const &figure) {
  std::vector<Point> points;
  for (int n = first; n <= last; ++n) points.push_back({static_cast<double>(n), static_cast<double>(figure(n))});
  return points;
}

TEST(Growth, APowerIsFoundAgain) {
  auto const fit = fit_power(family(1, 10, [](double n) { return 3 * std::pow(n, 2.5); }));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->factor, 3, 1e-9);
  EXPECT_NEAR(fit->exponent, 2.5, 1e-9);
  EXPECT_NEAR(fit->residual, 0, 1e-9);
  EXPECT_EQ(to_string(*fit, "N"), "3 N^2.50");
}

TEST(Growth, ThereIsNoPowerOfWhatIsNotPositive) {
  EXPECT_FALSE(fit_power(family(0, 5, [](double) { return 1; })));
  EXPECT_FALSE(fit_power(family(1, 5, [](double n) { return n - 1; })));
  EXPECT_FALSE(fit_power({{3, 5}}));
}

TEST(Growth, IntegersOfAPolynomialAreMetExactly) {
  for (std::size_t degree = 0; degree <= 6; ++degree) {
    auto const value = [&](long n) {
      long sum = 7;
      for (std::size_t k = 1; k <= degree; ++k) sum += static_cast<long>(std::pow(n, k)) * (k % 2 ? 3 : -2);
      return sum;
    };
    auto const fit = fit_polynomial(family(1, 20, value));
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->is_exact) << degree;
    EXPECT_EQ(fit->coefficient.size(), degree + 1);
    EXPECT_EQ(fit->from, 1);
    for (long n = 1; n <= 20; ++n) EXPECT_NEAR(fit->at(static_cast<double>(n)), static_cast<double>(value(n)), 1e-3);
  }
}

TEST(Growth, TheFirstMembersMayDiffer) {
  auto const fit = fit_polynomial(family(1, 12, [](int n) { return n < 3 ? 1 : 5 * n * n - n + 2; }));
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->is_exact);
  EXPECT_EQ(fit->from, 3);
  EXPECT_EQ(to_string(*fit, "N"), "5 N^2 - N + 2");
}

TEST(Growth, WhatIsNoPolynomialHasAResidual) {
  auto const fit = fit_polynomial(family(1, 30, [](double n) { return std::round(100 * std::sqrt(n)); }));
  ASSERT_TRUE(fit);
  EXPECT_FALSE(fit->is_exact);
  EXPECT_GT(fit->residual, 0);
  EXPECT_LT(fit->residual, 0.1);
}

// A line but for what rounding and the first member leave.
TEST(Growth, TheSmallestDegreeThatIsCloseIsTaken) {
  auto const fit = fit_polynomial(family(1, 10, [](int n) { return n == 1 ? 5 : 95 * n / 10; }));
  ASSERT_TRUE(fit);
  EXPECT_FALSE(fit->is_exact);
  ASSERT_EQ(fit->coefficient.size(), 2U);
  EXPECT_NEAR(fit->coefficient[1], 9.5, 0.5);
}

// Two points are met by every line, and say nothing of a degree.
TEST(Growth, TooFewPointsAreNoLaw) {
  auto const fit = fit_polynomial({{1, 1}, {2, 8}});
  ASSERT_TRUE(fit);
  EXPECT_FALSE(fit->is_exact);
  EXPECT_EQ(fit->coefficient.size(), 1U);
  EXPECT_FALSE(fit_polynomial({{1, 1}}));
}

} // namespace
} // namespace symreal
