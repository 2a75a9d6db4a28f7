#include "runtime/replay/compare.h"
#include "runtime/replay/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace symreal;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Ulp, CountsTheDoublesBetween) {
  EXPECT_EQ(ulp_distance(1, std::nextafter(1, 2)), 1u);
  EXPECT_EQ(ulp_distance(0.0, -0.0), 0u);
  EXPECT_EQ(ulp_distance(-0x1p-1074, 0x1p-1074), 2u);
  EXPECT_EQ(ulp_distance(nan, -nan), 0u);
  EXPECT_EQ(ulp_distance(nan, 1), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(ulp_distance(infinity, std::numeric_limits<double>::max()), 1u);
  EXPECT_GT(ulp_distance(-infinity, infinity), std::uint64_t{1} << 62);
}

TEST(Same, DependsOnTheMode) {
  EXPECT_TRUE(same(0.0, -0.0, FloatingPoint::finite, 0));
  EXPECT_FALSE(same(0.0, -0.0, FloatingPoint::strict, 0));
  EXPECT_TRUE(same(nan, -nan, FloatingPoint::strict, 0));
  EXPECT_FALSE(same(nan, nan, FloatingPoint::finite, 0));
  EXPECT_FALSE(same(1, 1 + 1e-15, FloatingPoint::finite, 1));
  EXPECT_TRUE(same(1e6, 1e6 + 1e-6, FloatingPoint::fast, 1e-9));
  EXPECT_FALSE(same(1, 1 + 1e-6, FloatingPoint::fast, 1e-9));
  EXPECT_TRUE(same(infinity, infinity, FloatingPoint::fast, 1e-9));
}

TEST(Same, TheDifferenceThatCountsIsShown) {
  OutputComparison comparison;
  comparison.add(0, 1e300, 1e300, FloatingPoint::fast, 1e-9);
  comparison.add(1, 1e-12, 2e-12, FloatingPoint::fast, 1e-9); // many doubles apart, within the tolerance
  comparison.add(2, 1, 1.001, FloatingPoint::fast, 1e-9);
  EXPECT_EQ(comparison.different, 1u);
  EXPECT_EQ(comparison.worst_sample, 2u);
}

Graph two_inputs() {
  Graph graph;
  graph.inputs = {{"q", {}, 0, 1, {}, Range{-1, 2}}, {"v", {}, 1, 1, {}, {}}};
  graph.parameters = {{"m", {}, 0, 1, {}, {}}};
  graph.input_values = {0.5, 3};
  graph.parameter_values = {7};
  return graph;
}

TEST(Samples, BeginWithTheRecordedValuesAndKeepToTheRange) {
  SampleSource source(two_inputs(), 1);
  Sample first = source.next();
  EXPECT_EQ(first.inputs, (std::vector<double>{0.5, 3}));
  EXPECT_EQ(first.parameters, std::vector<double>{7});
  double largest = 0;
  for (int i = 0; i < 1000; ++i) {
    Sample sample = source.next();
    EXPECT_TRUE(sample.inputs[0] >= -1 && sample.inputs[0] <= 2);
    EXPECT_TRUE(std::isfinite(sample.inputs[1]));
    EXPECT_LE(std::abs(sample.parameters[0]), 14);
    largest = std::max(largest, std::abs(sample.inputs[1]));
  }
  EXPECT_GT(largest, 1e6);
}

TEST(Samples, DependOnTheSeedAlone) {
  SampleSource a(two_inputs(), 5), b(two_inputs(), 5), c(two_inputs(), 6);
  bool differs = false;
  for (int i = 0; i < 50; ++i) {
    Sample x = a.next(), y = b.next(), z = c.next();
    EXPECT_EQ(x.inputs, y.inputs);
    differs |= x.inputs != z.inputs;
  }
  EXPECT_TRUE(differs);
}

} // namespace
